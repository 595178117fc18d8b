// SPDX-License-Identifier: MIT
#include "avionics/telemetry.hpp"

#include <algorithm>

#include "avionics/can_frame.hpp"
#include "core/per_canard.hpp"

namespace fantail::avionics {
namespace {

// Milliseconds.
constexpr std::uint32_t motion_period = 10;
constexpr std::uint32_t sensor_period = 20;
constexpr std::uint32_t health_period = 100;
constexpr std::uint32_t slow_period = 1000;
// Their ticks within it.
constexpr std::uint32_t rejections_at = 55;
constexpr std::uint32_t limits_at = 66;
constexpr std::uint32_t board_at = 77;

void put(const protocol::BusFrame& frame, hal::CanBus& bus) {
  // A frame that finds no room is counted by the bus; there will be another.
  (void)bus.send(can_frame(frame));
}

// Cut off, not rounded: a counter that only ever differs.
std::uint8_t low_byte(std::uint32_t value) { return static_cast<std::uint8_t>(value & 0xFFU); }

protocol::PerCanard driven_angles(const core::CanardCommands& commands) {
  return core::per_canard(
      [&](std::size_t i) { return commands[i].driven ? std::optional{commands[i].angle} : std::nullopt; });
}

protocol::StatusReport status(const core::TickRecord& record, const Report& report, bool every_tick) {
  protocol::StatusReport status{.phase = record.phase,
                                .reason = record.reason,
                                .command_status = record.command_status,
                                .roll_command = record.command,
                                .saturated = record.saturated,
                                .arm_switch_closed = report.situation.arm_switch_closed,
                                .at_rest = report.situation.at_rest,
                                .session_open = report.session_open,
                                .self_test_running = report.self_test_running,
                                .timing_fault = record.timing_fault,
                                .every_tick = every_tick,
                                .abort = report.situation.abort == protocol::AbortState::asks_to_abort,
                                .gyro_bias_rad_s = record.motion.gyro_bias_rad_s.x};
  for (std::size_t i = 0; i < status.limited.size(); ++i) {
    status.limited[i] = record.canards[i].limited;
  }
  return status;
}

}  // namespace

void Telemetry::send(const core::TickRecord& record, const core::Inputs& inputs, const Report& report,
                     hal::CanBus& bus) {
  const bool every_tick = core::is_flight(record.phase) || report.self_test_running || report.session_open;
  if (every_tick || ticks_ % motion_period == 0) {
    put(encode(protocol::CommandReport{driven_angles(record.canards)}, command_counter_.next()), bus);
    put(encode(protocol::EncoderReport{record.encoders}, encoder_counter_.next()), bus);
  }
  if (ticks_ % motion_period == 3) {
    put(encode(status(record, report, every_tick)), bus);
  }
  if (ticks_ % motion_period == 6) {
    put(encode(protocol::MotionReport{.roll_angle = record.motion.roll_angle,
                                      .roll_rate_rad_s = record.motion.roll_rate_rad_s,
                                      .height_m = record.motion.height_m,
                                      .speed_m_s = record.motion.speed_m_s}),
        bus);
  }
  if (record.phase == core::Phase::safe) {
    send_sensors(inputs, bus);
  }
  if (report.plan) {
    put(encode(*report.plan), bus);
  }
  // Answers at once, and again in case that somebody came late.
  if (report.session_is_news || ticks_ % health_period == 11) {
    put(encode(report.session), bus);
  }
  if (report.session_refusal) {
    put(encode(*report.session_refusal), bus);
  }
  if (report.arming != last_arming_ || ticks_ % health_period == 22) {
    last_arming_ = report.arming;
    put(encode(report.arming), bus);
  }
  send_health(record, report, bus);
  ticks_ += 1;
}

bool Telemetry::slow_report_is_due() const {
  const std::uint32_t tick = ticks_ % slow_period;
  return tick == rejections_at || tick == limits_at || tick == board_at;
}

void Telemetry::send_sensors(const core::Inputs& inputs, hal::CanBus& bus) const {
  if (ticks_ % sensor_period == 8) {
    put(encode(protocol::GyroReport{.rate_rad_s = inputs.gyro.rate_rad_s,
                                    .quality = inputs.gyro.quality,
                                    .time_ms = static_cast<std::uint16_t>((inputs.time.count() / 1000) & 0x3FFF)}),
        bus);
  } else if (ticks_ % sensor_period == 18) {
    const bool second = ticks_ / sensor_period % 2 == 1;
    const core::AccelerometerSample& sample = inputs.accelerometers[second ? 1 : 0];
    put(encode(protocol::AccelerometerReport{
            .specific_force_m_s2 = sample.specific_force_m_s2,
            .sensor = second ? protocol::Accelerometer::second : protocol::Accelerometer::of_imu,
            .quality = sample.quality}),
        bus);
  }
}

void Telemetry::send_health(const core::TickRecord& record, const Report& report, hal::CanBus& bus) {
  longest_tick_ = std::max(longest_tick_, report.tick_duration);
  if (ticks_ % health_period == 33) {
    const hal::CanCounters counters = bus.counters();
    constexpr std::int64_t most_us = 0xFFFF;
    put(encode(protocol::HealthReport{
            .verdicts = record.verdicts,
            .gyro = record.motion.gyro,
            .accelerometer = record.motion.accelerometer,
            .bus_state = static_cast<std::uint8_t>(bus.state()),
            .unsent = low_byte(counters.unsent),
            .overrun = low_byte(counters.overrun),
            .bus_errors = low_byte(counters.errors),
            .longest_tick_us = static_cast<std::uint16_t>(std::min(std::int64_t{longest_tick_.count()}, most_us))}),
        bus);
    longest_tick_ = {};
  }
  if (ticks_ % health_period == 44) {
    const auto uptime_ms = static_cast<std::uint32_t>((record.time.count() / 1000) & 0xFFFFFF);
    put(encode(protocol::HeartbeatReport{.uptime_ms = uptime_ms, .plan_crc = report.plan_crc}), bus);
  }
  if (!report.slow) {
    return;
  }
  if (ticks_ % slow_period == rejections_at) {
    put(encode(report.slow->rejections), bus);
  }
  if (ticks_ % slow_period == limits_at) {
    put(encode(report.slow->limits), bus);
  }
  if (report.slow->board_is_news || ticks_ % slow_period == board_at) {
    put(encode(report.slow->board), bus);
  }
}

}  // namespace fantail::avionics
