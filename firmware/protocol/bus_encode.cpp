// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "protocol/bus_choices.hpp"
#include "protocol/bus_codec.hpp"
#include "protocol/bus_frames.hpp"
#include "protocol/bus_log_choices.hpp"

namespace fantail::protocol {
namespace {

// PlanData and LogData are alike.
template <typename Frame>
BusFrame pack_data(const auto& message) {
  typename Frame::Raw raw{};
  raw.index = message.index;
  for (std::size_t i = 0; i < message.bytes.size(); ++i) {
    raw.*signals::bytes<typename Frame::Raw>[i] = std::to_integer<std::uint8_t>(message.bytes[i]);
  }
  return Frame::pack(raw);
}

}  // namespace

BusFrame encode(const BenchSession& message, std::uint8_t counter) {
  BenchSessionFrame::Raw raw{};
  raw.action = raw_of(message.action);
  raw.session = message.session;
  return protect<BenchSessionFrame>(raw, counter);
}

BusFrame encode(const ArmRequest& message, std::uint8_t counter) {
  ArmRequestFrame::Raw raw{};
  raw.action = raw_of(message.action);
  raw.nonce = message.nonce;
  return protect<ArmRequestFrame>(raw, counter);
}

BusFrame encode(const PlanBegin& message, std::uint8_t counter) {
  PlanBeginFrame::Raw raw{};
  raw.size = message.size;
  raw.block_crc = message.block_crc;
  return protect<PlanBeginFrame>(raw, counter);
}

BusFrame encode(const PlanData& message) { return pack_data<PlanDataFrame>(message); }

BusFrame encode(const LogRequest& message, std::uint8_t counter) {
  constexpr std::uint16_t twelve_bits = 0xFFF;
  LogRequestFrame::Raw raw{};
  raw.action = raw_of(message.action);
  raw.tag = message.tag & 0x0FU;
  raw.offset = message.offset;
  raw.size = std::min(message.size, twelve_bits);
  return protect<LogRequestFrame>(raw, counter);
}

BusFrame encode(const StatusReport& message) {
  StatusReportFrame::Raw raw{};
  raw.phase = raw_of(message.phase);
  raw.reason = raw_of(message.reason);
  raw.command_status = raw_of(message.command_status);
  raw.roll_command = RollCommand{}.raw(message.roll_command.degrees());
  raw.saturated = message.saturated;
  raw.arm_switch_closed = message.arm_switch_closed;
  raw.at_rest = message.at_rest;
  raw.session_open = message.session_open;
  raw.self_test_running = message.self_test_running;
  raw.timing_fault = message.timing_fault;
  raw.every_tick = message.every_tick;
  raw.abort = message.abort;
  raw.gyro_bias = GyroBias{}.raw(core::Angle::from_radians(message.gyro_bias_rad_s).degrees());
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    raw.*signals::limited[i] = message.limited[i];
  }
  return StatusReportFrame::pack(raw);
}

BusFrame encode(const MotionReport& message) {
  return MotionReportFrame::pack(
      {.roll_angle = RollAngle{}.raw(message.roll_angle.degrees()),
       .roll_rate = RollRate{}.raw(core::Angle::from_radians(message.roll_rate_rad_s).degrees()),
       .height = Height{}.raw(message.height_m),
       .speed = Speed{}.raw(message.speed_m_s)});
}

BusFrame encode(const SessionReply& message) {
  return SessionReplyFrame::pack(
      {.state = raw_of(message.state), .reason = raw_of(message.reason), .session = message.session});
}

BusFrame encode(const ArmReply& message) {
  ArmReplyFrame::Raw raw{};
  raw.self_test = raw_of(message.self_test);
  raw.failure = raw_of(message.failure);
  raw.nonce_given = message.nonce.has_value();
  raw.refusal = raw_of(message.refusal);
  raw.nonce = message.nonce.value_or(0);
  raw.abort_input = raw_of(message.abort_input);
  if (message.canard) {
    raw.canard = static_cast<std::uint8_t>(std::min(*message.canard, core::canard_count - 1) +
                                           CANARD_BUS_ARM_REPLY_CANARD_CANARD_1_CHOICE);
  }
  return ArmReplyFrame::pack(raw);
}

BusFrame encode(const PlanReply& message) {
  PlanReplyFrame::Raw raw{};
  raw.state = raw_of(message.state);
  raw.fault = raw_of(message.fault);
  raw.next_index = message.next_index;
  raw.field = message.field.value_or(0);
  raw.field_given = message.field.has_value();
  if (message.block_fault) {
    raw.block_fault = static_cast<std::uint8_t>(raw_of(*message.block_fault) + 1U);
  }
  return PlanReplyFrame::pack(raw);
}

BusFrame encode(const LogReply& message) {
  LogReplyFrame::Raw raw{};
  raw.state = raw_of(message.state);
  raw.fault = raw_of(message.fault);
  raw.tag = message.tag & 0x0FU;
  raw.number = message.number;
  raw.extra = message.extra;
  return LogReplyFrame::pack(raw);
}

BusFrame encode(const LogData& message) { return pack_data<LogDataFrame>(message); }

BusFrame encode(const HealthReport& message) {
  constexpr std::uint8_t last_state = CANARD_BUS_HEALTH_REPORT_BUS_STATE_DOWN_CHOICE;
  HealthReportFrame::Raw raw{};
  raw.gyro = raw_of(message.gyro);
  raw.accelerometer = raw_of(message.accelerometer);
  raw.bus_state = std::min(message.bus_state, last_state);
  raw.unsent = message.unsent;
  raw.overrun = message.overrun;
  raw.bus_errors = message.bus_errors;
  raw.longest_tick = message.longest_tick_us;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    raw.*signals::verdicts[i] = raw_of(message.verdicts[i]);
  }
  return HealthReportFrame::pack(raw);
}

BusFrame encode(const RejectionReport& message) {
  const auto of = [&](Rejection cause) { return message.count[static_cast<std::size_t>(cause)]; };
  return RejectionReportFrame::pack({.unknown_id = of(Rejection::unknown_id),
                                     .wrong_length = of(Rejection::wrong_length),
                                     .wrong_crc = of(Rejection::wrong_crc),
                                     .wrong_counter = of(Rejection::wrong_counter),
                                     .out_of_range = of(Rejection::out_of_range),
                                     .stale = of(Rejection::stale)});
}

BusFrame encode(const LimitReport& message) {
  LimitReportFrame::Raw raw{};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    raw.*signals::limits[i] = CanardLimit{}.raw(message.limit[i].degrees());
  }
  return LimitReportFrame::pack(raw);
}

BusFrame encode(const BoardReport& message) {
  constexpr std::uint8_t last_cause = CANARD_BUS_BOARD_REPORT_RESET_CAUSE_WATCHDOG_CHOICE;
  BoardReportFrame::Raw raw{};
  raw.faults = message.faults;
  raw.battery = message.battery_mv.value_or(0);
  raw.overruns = message.overruns;
  raw.reset_cause = std::min(message.reset_cause, last_cause);
  raw.plan = raw_of(message.plan);
  raw.battery_given = message.battery_mv.has_value();
  raw.flash_failed = message.flash_failed;
  return BoardReportFrame::pack(raw);
}

BusFrame encode(const GyroReport& message) {
  constexpr std::uint16_t fourteen_bits = 0x3FFF;
  const auto raw = [scale = BodyRate{}](float rate_rad_s) {
    return scale.raw(core::Angle::from_radians(rate_rad_s).degrees());
  };
  return GyroReportFrame::pack({.x = raw(message.rate_rad_s.x),
                                .y = raw(message.rate_rad_s.y),
                                .z = raw(message.rate_rad_s.z),
                                .time = static_cast<std::uint16_t>(message.time_ms & fourteen_bits),
                                .quality = raw_of(message.quality)});
}

BusFrame encode(const AccelerometerReport& message) {
  const SpecificForce scale;
  return AccelerometerReportFrame::pack({.x = scale.raw(message.specific_force_m_s2.x),
                                         .y = scale.raw(message.specific_force_m_s2.y),
                                         .z = scale.raw(message.specific_force_m_s2.z),
                                         .sensor = raw_of(message.sensor),
                                         .quality = raw_of(message.quality)});
}

BusFrame encode(const HeartbeatReport& message) {
  constexpr std::uint32_t three_bytes = 0xFFFFFFU;
  return HeartbeatReportFrame::pack(
      {.version = message.version, .uptime = message.uptime_ms & three_bytes, .plan_crc = message.plan_crc});
}

}  // namespace fantail::protocol
