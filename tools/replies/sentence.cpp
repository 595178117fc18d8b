// SPDX-License-Identifier: MIT
#include "replies/sentence.hpp"

#include "core/flight_plan_fields.hpp"

namespace fantail::replies {
namespace {

std::string sentence(protocol::PlanBlockFault fault) {
  using Fault = protocol::PlanBlockFault;
  switch (fault) {
    case Fault::too_short: return "it is too short to be a plan";
    case Fault::no_plan_block: return "it is not a plan";
    case Fault::wrong_length: return "its length is wrong";
    case Fault::wrong_checksum: return "its checksum is wrong";
    case Fault::older_version:
      return "it was made for an older version of the firmware: compile it with the release that the board has";
    case Fault::newer_version:
      return "it was made for a newer version of the firmware: flash that version, or compile it with the board's";
    case Fault::other_schema:
      return "it was made for another version of the firmware: compile it with the same release";
    case Fault::refused: return "one of its values is out of range";
  }
  return "unknown reason";
}

}  // namespace

std::string_view name(hal::CanState state) {
  switch (state) {
    case hal::CanState::error_active: return "error active";
    case hal::CanState::error_warning: return "error warning";
    case hal::CanState::error_passive: return "error passive";
    case hal::CanState::bus_off: return "bus off";
    case hal::CanState::down: return "down";
  }
  return "unknown";
}

std::string sentence(protocol::SessionReason reason) {
  using Reason = protocol::SessionReason;
  switch (reason) {
    case Reason::none_yet: return "there has been no session yet";
    case Reason::opened: return "it is open";
    case Reason::closed_by_bench: return "a bench closed it";
    case Reason::heartbeat_lost: return "no heartbeat from the bench arrived for 0.1 s";
    case Reason::not_safe: return "the rocket is not in phase safe; open the arm switch";
    case Reason::not_at_rest:
      return "the rocket is moving; it must stand still for the plan's rest time (2 s unless changed)";
    case Reason::self_test_runs: return "the self-test is running";
    case Reason::other_session: return "another bench has the session";
    case Reason::number_too_similar: return "its number is too similar to that of the session before";
  }
  return "unknown reason";
}

std::string sentence(protocol::SelfTestFailure failure, const std::optional<std::size_t>& canard) {
  using Failure = protocol::SelfTestFailure;
  const std::string which = canard ? "canard " + std::to_string(*canard + 1) : "a canard";
  switch (failure) {
    case Failure::none: return "no reason given";
    case Failure::not_safe: return "the rocket is not in phase safe";
    case Failure::moved: return "the rocket did not stand still";
    case Failure::gyro_failed: return "the gyro gives no usable rate";
    case Failure::accelerometer_failed: return "an accelerometer that the plan requires gives no usable sample";
    case Failure::specific_force_not_one_g:
      return "an accelerometer does not read 1 g along the axis (0.9 to 1.1 g); perhaps the rocket is not upright";
    case Failure::accelerometers_disagree: return "the two accelerometers disagree by more than the plan allows";
    case Failure::encoder_silent: return "the encoder of " + which + " is silent";
    case Failure::canard_did_not_follow: return which + " is not at the angle it was commanded to";
    case Failure::another_canard_moved:
      return which + " moved when it was not its turn: are two servos or two encoders swapped?";
    case Failure::no_valid_plan: return "the plan in the flash is broken; send it again";
    case Failure::flash_failed: return "the flash does not answer";
    case Failure::flash_too_full: return "the flash has no room for a flight";
    case Failure::timed_out: return "it took too long";
    case Failure::board_fault: return "the board has a fault; `fantail bench watch` shows it";
    case Failure::second_gyro_failed: return "the second gyro that the plan requires gives no usable rate";
    case Failure::gyros_disagree: return "the two gyros disagree by more than the plan allows";
    case Failure::gyro_turns:
      return "the gyro reads a steady turn: its zero is off by more than half the plan's motion.quiet_rate_deg_s, or "
             "the rocket turns";
    case Failure::second_gyro_turns:
      return "the second gyro reads a steady turn: its zero is off by more than half the plan's "
             "motion.quiet_rate_deg_s, or the rocket turns";
    case Failure::barometer_failed:
      return "the barometer that the plan requires gives no pressure from 560 to 1120 hPa";
    case Failure::newer_plan:
      return "the plan in the flash was made for a newer version of the firmware: flash that version, or send a plan";
  }
  return "unknown reason";
}

std::string sentence(protocol::ArmRefusal refusal) {
  using Refusal = protocol::ArmRefusal;
  switch (refusal) {
    case Refusal::none: return "no reason given";
    case Refusal::not_safe: return "the rocket is not in phase safe";
    case Refusal::session_open: return "a bench session is open";
    case Refusal::self_test_not_passed: return "no self-test has passed within the last minute";
    case Refusal::switch_not_cycled: return "the arm switch has been closed since power-up; open it and close it again";
    case Refusal::switch_open: return "the arm switch is open";
    case Refusal::not_at_rest: return "the rocket is moving";
    case Refusal::no_nonce: return "there is nothing to confirm";
    case Refusal::nonce_expired: return "the confirmation came more than 5 s after the request";
    case Refusal::wrong_nonce: return "the confirmation was not for this request";
    case Refusal::not_a_tunnel_plan: return "its plan starts by launch detection, not on command";
    case Refusal::not_armed: return "it is not armed";
    case Refusal::abort_not_ready: return "the abort input asks to abort, or its contact chatters";
    case Refusal::board_fault: return "the board has a fault; `fantail bench watch` shows it";
  }
  return "unknown reason";
}

std::string sentence(protocol::LogFault fault) {
  using Fault = protocol::LogFault;
  switch (fault) {
    case Fault::none: return "no reason given";
    case Fault::not_safe:
      return "the rocket is not in phase safe; open the arm switch, and after a flight switch it off and on";
    case Fault::no_session: return "no bench session is open";
    case Fault::busy: return "its flash is busy";
    case Fault::not_counted_yet: return "it is still scanning its flash";
    case Fault::out_of_range: return "the record is not that long";
    case Fault::flash_failed: return "its flash does not answer";
  }
  return "unknown reason";
}

std::string sentence(const protocol::PlanReply& reply) {
  using Fault = protocol::TransferFault;
  switch (reply.fault) {
    case Fault::none: return "no reason given";
    case Fault::not_safe: return "the rocket is not in phase safe, moves, or its canards are being moved";
    case Fault::wrong_size: return "a plan cannot have that size";
    case Fault::out_of_order: return "its parts arrived out of order";
    case Fault::timed_out: return "the next part did not arrive within a second";
    case Fault::flash_failed: return "the flash does not answer";
    case Fault::read_back_differs: return "the data read back from the flash differ from the written data";
    case Fault::bad_block: break;
  }
  if (reply.field && *reply.field < core::flight_plan_fields().size()) {
    const core::PlanField& field = core::flight_plan_fields()[*reply.field];
    return std::string{field.section} + "." + std::string{field.key} + " is out of range";
  }
  return reply.block_fault ? sentence(*reply.block_fault) : "unknown reason";
}

std::string_view sentence(protocol::AbortState state) {
  switch (state) {
    case protocol::AbortState::none_fitted: return "none fitted";
    case protocol::AbortState::ready: return "ready";
    case protocol::AbortState::asks_to_abort: return "asks to abort";
    case protocol::AbortState::unsettled: return "its contact chatters";
  }
  return "unknown";
}

std::string_view name(protocol::AbortState state) {
  switch (state) {
    case protocol::AbortState::none_fitted: return "none_fitted";
    case protocol::AbortState::ready: return "ready";
    case protocol::AbortState::asks_to_abort: return "asks_to_abort";
    case protocol::AbortState::unsettled: return "unsettled";
  }
  return "unknown";
}

std::string_view name(protocol::PlanSource source) {
  switch (source) {
    case protocol::PlanSource::built_in: return "built_in";
    case protocol::PlanSource::stored: return "stored";
    case protocol::PlanSource::stored_is_broken: return "stored_is_broken";
    case protocol::PlanSource::stored_is_newer: return "stored_is_newer";
    case protocol::PlanSource::flash_unreadable: return "flash_unreadable";
  }
  return "unknown";
}

}  // namespace fantail::replies
