// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>

#include <fmt/format.h>

#include "core/canard_mixer.hpp"
#include "log_export/formats.hpp"
#include "protocol/bus_codec.hpp"

namespace fantail::log_export {
namespace {

using protocol::BusFrame;

std::uint8_t low_byte(std::uint32_t value) { return static_cast<std::uint8_t>(value & 0xFFU); }

protocol::PerCanard driven_angles(const core::CanardCommands& commands) {
  protocol::PerCanard angles;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (commands[i].driven) {
      angles[i] = commands[i].angle;
    }
  }
  return angles;
}

// Follows the order and the periods of the avionics' telemetry.
class Bus {
 public:
  explicit Bus(const ReplayedFlight& source) : source_{source} {
    const flight_log::Flight& flight = source.flight();
    if (flight.plan) {
      const core::CanardMixer mixer{flight.plan->canards, flight.plan->controller.canard_limit};
      limits_.emplace();
      for (std::size_t i = 0; i < limits_->limit.size(); ++i) {
        limits_->limit[i] = mixer.limit(i);
      }
    }
  }

  std::string text() {
    const auto& ticks = source_.flight().ticks;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      const core::Microseconds time = ticks[i].tick.time;
      send_health(time - core::Microseconds{1});
      if (source_.inside(time)) {
        if (const core::TickRecord* record = source_.record(i)) {
          send(*record, ticks[i].tick);
        }
      }
    }
    send_health(core::Microseconds::max());
    return fmt::to_string(out_);
  }

 private:
  void put(core::Microseconds time, const BusFrame& frame) {
    fmt::format_to(std::back_inserter(out_), "({}.{:06}) can0 {:03X}#", time.count() / 1'000'000,
                   time.count() % 1'000'000, frame.id);
    for (std::size_t i = 0; i < frame.length; ++i) {
      fmt::format_to(std::back_inserter(out_), "{:02X}", frame.data[i]);
    }
    out_.push_back('\n');
  }

  void send(const core::TickRecord& record, const protocol::LogTick& tick) {
    const std::int64_t millisecond = record.time.count() / 1000;
    const bool every_tick = core::is_flight(record.phase);
    if (every_tick || millisecond % 10 == 0) {
      put(record.time, encode(protocol::CommandReport{driven_angles(record.canards)}, command_counter_.next()));
      put(record.time, encode(protocol::EncoderReport{record.encoders}, encoder_counter_.next()));
    }
    if (millisecond % 10 == 3) {
      put(record.time, encode(status(record, tick, every_tick)));
    }
    if (millisecond % 10 == 6) {
      put(record.time, encode(protocol::MotionReport{.roll_angle = record.motion.roll_angle,
                                                     .roll_rate_rad_s = record.motion.roll_rate_rad_s,
                                                     .height_m = record.motion.height_m,
                                                     .speed_m_s = record.motion.speed_m_s}));
    }
    if (millisecond % 100 == 44 && source_.flight().plan) {
      put(record.time,
          encode(protocol::HeartbeatReport{.uptime_ms = static_cast<std::uint32_t>(millisecond & 0xFFFFFF),
                                           .plan_crc = protocol::plan_block_crc(source_.flight().plan_block)}));
    }
    if (millisecond % 1000 == 66 && limits_) {
      put(record.time, encode(*limits_));
    }
  }

  [[nodiscard]] protocol::StatusReport status(const core::TickRecord& record, const protocol::LogTick& tick,
                                              bool every_tick) const {
    const auto& plan = source_.flight().plan;
    protocol::StatusReport report{.phase = record.phase,
                                  .reason = record.reason,
                                  .command_status = record.command_status,
                                  .roll_command = record.command,
                                  .saturated = record.saturated,
                                  .arm_switch_closed = tick.arm_switch_closed,
                                  .at_rest = plan && record.motion.at_rest_for >= plan->motion.rest_time,
                                  .timing_fault = record.timing_fault,
                                  .every_tick = every_tick,
                                  .abort = tick.abort,
                                  .gyro_bias_rad_s = record.motion.gyro_bias_rad_s.x};
    for (std::size_t i = 0; i < report.limited.size(); ++i) {
      report.limited[i] = record.canards[i].limited;
    }
    return report;
  }

  // Health stands in the log by itself, for its own ticks.
  void send_health(core::Microseconds until) {
    const auto& health = source_.flight().health;
    for (; next_health_ < health.size() && health[next_health_].time <= until; ++next_health_) {
      const protocol::LogHealth& record = health[next_health_];
      if (source_.inside(record.time)) {
        put(record.time, encode(protocol::HealthReport{.verdicts = record.verdicts,
                                                       .gyro = record.gyro,
                                                       .accelerometer = record.accelerometer,
                                                       .bus_state = record.bus_state,
                                                       .unsent = low_byte(record.unsent),
                                                       .overrun = 0,
                                                       .bus_errors = low_byte(record.bus_errors),
                                                       .longest_tick_us = record.longest_tick_us}));
      }
    }
  }

  const ReplayedFlight& source_;
  std::optional<protocol::LimitReport> limits_;
  protocol::FrameCounter command_counter_;
  protocol::FrameCounter encoder_counter_;
  std::size_t next_health_ = 0;
  fmt::memory_buffer out_;
};

}  // namespace

std::string candump(const ReplayedFlight& source) { return Bus{source}.text(); }

}  // namespace fantail::log_export
