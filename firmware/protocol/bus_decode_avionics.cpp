// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <optional>

#include "protocol/bus_choices.hpp"
#include "protocol/bus_codec.hpp"
#include "protocol/bus_frames.hpp"
#include "protocol/bus_log_choices.hpp"

namespace fantail::protocol {
namespace {

std::optional<CommandReport> read_command(const CommandReportFrame::Raw& raw) {
  const auto angles = signals::driven.angles(raw);
  return angles ? std::optional{CommandReport{.angle = *angles}} : std::nullopt;
}

std::optional<EncoderReport> read_encoder(const EncoderReportFrame::Raw& raw) {
  const auto angles = signals::valid.angles(raw);
  return angles ? std::optional{EncoderReport{.angle = *angles}} : std::nullopt;
}

std::optional<StatusReport> read_status(const StatusReportFrame::Raw& raw) {
  const auto phase = known<core::Phase>(raw.phase);
  const auto reason = known<core::PhaseReason>(raw.reason);
  const auto command_status = known<core::CommandStatus>(raw.command_status);
  if (!phase || !reason || !command_status || !canard_bus_status_report_roll_command_is_in_range(raw.roll_command) ||
      !canard_bus_status_report_gyro_bias_is_in_range(raw.gyro_bias)) {
    return std::nullopt;
  }
  StatusReport message{.phase = *phase,
                       .reason = *reason,
                       .command_status = *command_status,
                       .roll_command = core::Angle::from_degrees(RollCommand::value(raw.roll_command)),
                       .saturated = raw.saturated != 0,
                       .arm_switch_closed = raw.arm_switch_closed != 0,
                       .at_rest = raw.at_rest != 0,
                       .session_open = raw.session_open != 0,
                       .self_test_running = raw.self_test_running != 0,
                       .timing_fault = raw.timing_fault != 0,
                       .every_tick = raw.every_tick != 0,
                       .abort = raw.abort != 0,
                       .gyro_bias_rad_s = core::Angle::from_degrees(GyroBias::value(raw.gyro_bias)).radians()};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    message.limited[i] = raw.*signals::limited[i] != 0;
  }
  return message;
}

std::optional<MotionReport> read_motion(const MotionReportFrame::Raw& raw) {
  if (!canard_bus_motion_report_roll_angle_is_in_range(raw.roll_angle) ||
      !canard_bus_motion_report_roll_rate_is_in_range(raw.roll_rate) ||
      !canard_bus_motion_report_height_is_in_range(raw.height) ||
      !canard_bus_motion_report_speed_is_in_range(raw.speed)) {
    return std::nullopt;
  }
  return MotionReport{.roll_angle = core::Angle::from_degrees(RollAngle::value(raw.roll_angle)),
                      .roll_rate_rad_s = core::Angle::from_degrees(RollRate::value(raw.roll_rate)).radians(),
                      .height_m = Height::value(raw.height),
                      .speed_m_s = Speed::value(raw.speed)};
}

std::optional<SessionReply> read_session(const SessionReplyFrame::Raw& raw) {
  const auto state = known<SessionState>(raw.state);
  const auto reason = known<SessionReason>(raw.reason);
  if (!state || !reason) {
    return std::nullopt;
  }
  return SessionReply{.state = *state, .reason = *reason, .session = raw.session};
}

std::optional<ArmReply> read_arm(const ArmReplyFrame::Raw& raw) {
  const auto self_test = known<SelfTestState>(raw.self_test);
  const auto failure = known<SelfTestFailure>(raw.failure);
  const auto refusal = known<ArmRefusal>(raw.refusal);
  const auto abort_input = known<AbortState>(raw.abort_input);
  if (!self_test || !failure || !refusal || !abort_input || !canard_bus_arm_reply_canard_is_in_range(raw.canard)) {
    return std::nullopt;
  }
  ArmReply message{.self_test = *self_test, .failure = *failure, .refusal = *refusal, .abort_input = *abort_input};
  if (raw.canard != CANARD_BUS_ARM_REPLY_CANARD_NONE_CHOICE) {
    message.canard = raw.canard - CANARD_BUS_ARM_REPLY_CANARD_CANARD_1_CHOICE;
  }
  if (raw.nonce_given != 0) {
    message.nonce = raw.nonce;
  }
  return message;
}

std::optional<PlanReply> read_plan(const PlanReplyFrame::Raw& raw) {
  const auto state = known<TransferState>(raw.state);
  const auto fault = known<TransferFault>(raw.fault);
  if (!state || !fault || !canard_bus_plan_reply_block_fault_is_in_range(raw.block_fault)) {
    return std::nullopt;
  }
  std::optional<PlanReply> message{std::in_place};
  message->state = *state;
  message->fault = *fault;
  message->next_index = raw.next_index;
  if (raw.block_fault != CANARD_BUS_PLAN_REPLY_BLOCK_FAULT_NONE_CHOICE) {
    message->block_fault = known<PlanBlockFault>(static_cast<std::uint8_t>(raw.block_fault - 1U));
  }
  if (raw.field_given != 0) {
    message->field = raw.field;
  }
  return message;
}

std::optional<LogReply> read_log(const LogReplyFrame::Raw& raw) {
  const auto state = known<LogState>(raw.state);
  const auto fault = known<LogFault>(raw.fault);
  if (!state || !fault) {
    return std::nullopt;
  }
  return LogReply{.state = *state, .fault = *fault, .tag = raw.tag, .number = raw.number, .extra = raw.extra};
}

std::optional<HealthReport> read_health(const HealthReportFrame::Raw& raw) {
  const auto gyro = known<core::SensorState>(raw.gyro);
  const auto accelerometer = known<core::SensorState>(raw.accelerometer);
  // uncovered: each state of a sensor has its number in two bits, and no number is left over
  if (!gyro || !accelerometer || !canard_bus_health_report_bus_state_is_in_range(raw.bus_state)) {
    return std::nullopt;
  }
  HealthReport message{.gyro = *gyro,
                       .accelerometer = *accelerometer,
                       .bus_state = raw.bus_state,
                       .unsent = raw.unsent,
                       .overrun = raw.overrun,
                       .bus_errors = raw.bus_errors,
                       .longest_tick_us = raw.longest_tick};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const auto verdict = known<core::CanardVerdict>(raw.*signals::verdicts[i]);
    if (!verdict) {
      return std::nullopt;
    }
    message.verdicts[i] = *verdict;
  }
  return message;
}

std::optional<RejectionReport> read_rejection(const RejectionReportFrame::Raw& raw) {
  return RejectionReport{
      .count = {raw.unknown_id, raw.wrong_length, raw.wrong_crc, raw.wrong_counter, raw.out_of_range, raw.stale}};
}

std::optional<LimitReport> read_limit(const LimitReportFrame::Raw& raw) {
  LimitReport message{};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    if (!canard_bus_limit_report_canard_1_is_in_range(raw.*signals::limits[i])) {
      return std::nullopt;
    }
    message.limit[i] = core::Angle::from_degrees(CanardLimit::value(raw.*signals::limits[i]));
  }
  return message;
}

std::optional<BoardReport> read_board(const BoardReportFrame::Raw& raw) {
  const auto plan = known<PlanSource>(raw.plan);
  if (!plan || !canard_bus_board_report_reset_cause_is_in_range(raw.reset_cause)) {
    return std::nullopt;
  }
  BoardReport message{.faults = raw.faults,
                      .reset_cause = raw.reset_cause,
                      .plan = *plan,
                      .flash_failed = raw.flash_failed != 0,
                      .overruns = raw.overruns};
  if (raw.battery_given != 0) {
    message.battery_mv = raw.battery;
  }
  return message;
}

std::optional<GyroReport> read_gyro(const GyroReportFrame::Raw& raw) {
  const auto quality = known<core::SampleQuality>(raw.quality);
  // uncovered: each quality has its number in two bits, and no number is left over
  if (!quality || !canard_bus_gyro_report_x_is_in_range(raw.x) || !canard_bus_gyro_report_y_is_in_range(raw.y) ||
      !canard_bus_gyro_report_z_is_in_range(raw.z)) {
    return std::nullopt;
  }
  const auto rate_rad_s = [](std::int16_t of) { return core::Angle::from_degrees(BodyRate::value(of)).radians(); };
  return GyroReport{.rate_rad_s = {rate_rad_s(raw.x), rate_rad_s(raw.y), rate_rad_s(raw.z)},
                    .quality = *quality,
                    .time_ms = raw.time};
}

std::optional<AccelerometerReport> read_accelerometer(const AccelerometerReportFrame::Raw& raw) {
  const auto sensor = known<Accelerometer>(raw.sensor);
  const auto quality = known<core::SampleQuality>(raw.quality);
  // uncovered: each sensor and each quality has its number in one bit and in two, and no number is left over
  if (!sensor || !quality || !canard_bus_accelerometer_report_x_is_in_range(raw.x) ||
      !canard_bus_accelerometer_report_y_is_in_range(raw.y) || !canard_bus_accelerometer_report_z_is_in_range(raw.z)) {
    return std::nullopt;
  }
  return AccelerometerReport{
      .specific_force_m_s2 = {SpecificForce::value(raw.x), SpecificForce::value(raw.y), SpecificForce::value(raw.z)},
      .sensor = *sensor,
      .quality = *quality};
}

std::optional<HeartbeatReport> read_heartbeat(const HeartbeatReportFrame::Raw& raw) {
  return HeartbeatReport{.version = raw.version, .uptime_ms = raw.uptime, .plan_crc = raw.plan_crc};
}

std::optional<LogData> read_data(const LogDataFrame::Raw& raw) {
  LogData message{.index = raw.index};
  for (std::size_t i = 0; i < message.bytes.size(); ++i) {
    message.bytes[i] = std::byte{raw.*signals::bytes<LogDataFrame::Raw>[i]};
  }
  return message;
}

}  // namespace

Decoded<FromAvionics> decode_from_avionics(const BusFrame& frame) {
  constexpr bool strict = false;
  switch (frame.id) {
    case CommandReportFrame::id: return decode_as<FromAvionics, CommandReportFrame, strict>(frame, read_command);
    case EncoderReportFrame::id: return decode_as<FromAvionics, EncoderReportFrame, strict>(frame, read_encoder);
    case StatusReportFrame::id: return decode_as<FromAvionics, StatusReportFrame, strict>(frame, read_status);
    case MotionReportFrame::id: return decode_as<FromAvionics, MotionReportFrame, strict>(frame, read_motion);
    case SessionReplyFrame::id: return decode_as<FromAvionics, SessionReplyFrame, strict>(frame, read_session);
    case ArmReplyFrame::id: return decode_as<FromAvionics, ArmReplyFrame, strict>(frame, read_arm);
    case PlanReplyFrame::id: return decode_as<FromAvionics, PlanReplyFrame, strict>(frame, read_plan);
    case LogReplyFrame::id: return decode_as<FromAvionics, LogReplyFrame, strict>(frame, read_log);
    case HealthReportFrame::id: return decode_as<FromAvionics, HealthReportFrame, strict>(frame, read_health);
    case RejectionReportFrame::id: return decode_as<FromAvionics, RejectionReportFrame, strict>(frame, read_rejection);
    case LimitReportFrame::id: return decode_as<FromAvionics, LimitReportFrame, strict>(frame, read_limit);
    case BoardReportFrame::id: return decode_as<FromAvionics, BoardReportFrame, strict>(frame, read_board);
    case GyroReportFrame::id: return decode_as<FromAvionics, GyroReportFrame, strict>(frame, read_gyro);
    case AccelerometerReportFrame::id:
      return decode_as<FromAvionics, AccelerometerReportFrame, strict>(frame, read_accelerometer);
    case HeartbeatReportFrame::id: return decode_as<FromAvionics, HeartbeatReportFrame, strict>(frame, read_heartbeat);
    case LogDataFrame::id: return decode_as<FromAvionics, LogDataFrame, strict>(frame, read_data);
    default: return {.rejection = Rejection::unknown_id};
  }
}

}  // namespace fantail::protocol
