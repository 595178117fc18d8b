// SPDX-License-Identifier: MIT
#pragma once

#include "core/inputs.hpp"
#include "core/tick_record.hpp"
#include "protocol/generated/canard_bus.h"

namespace fantail::protocol {

// Inside the codec only. Each enumerator beside its choice (a named value of a signal) in the database: a new
// enumerator that the database does not know is a warning of the compiler (a case is missing), and one that stands
// elsewhere fails the assertion below.

inline constexpr unsigned no_choice = 256;

constexpr unsigned choice(core::Phase value) {
  switch (value) {
    using enum core::Phase;
    case safe: return CANARD_BUS_STATUS_REPORT_PHASE_SAFE_CHOICE;
    case armed: return CANARD_BUS_STATUS_REPORT_PHASE_ARMED_CHOICE;
    case launched: return CANARD_BUS_STATUS_REPORT_PHASE_LAUNCHED_CHOICE;
    case controlling: return CANARD_BUS_STATUS_REPORT_PHASE_CONTROLLING_CHOICE;
    case finished: return CANARD_BUS_STATUS_REPORT_PHASE_FINISHED_CHOICE;
    case dormant: return CANARD_BUS_STATUS_REPORT_PHASE_DORMANT_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(core::PhaseReason value) {
  switch (value) {
    using enum core::PhaseReason;
    case power_on: return CANARD_BUS_STATUS_REPORT_REASON_POWER_ON_CHOICE;
    case armed_by_switch_and_command: return CANARD_BUS_STATUS_REPORT_REASON_ARMED_BY_SWITCH_AND_COMMAND_CHOICE;
    case disarmed_by_switch: return CANARD_BUS_STATUS_REPORT_REASON_DISARMED_BY_SWITCH_CHOICE;
    case launch_detected: return CANARD_BUS_STATUS_REPORT_REASON_LAUNCH_DETECTED_CHOICE;
    case guide_clear: return CANARD_BUS_STATUS_REPORT_REASON_GUIDE_CLEAR_CHOICE;
    case tunnel_start_command: return CANARD_BUS_STATUS_REPORT_REASON_TUNNEL_START_COMMAND_CHOICE;
    case guide_not_cleared_in_time: return CANARD_BUS_STATUS_REPORT_REASON_GUIDE_NOT_CLEARED_IN_TIME_CHOICE;
    case gyro_failed_before_control: return CANARD_BUS_STATUS_REPORT_REASON_GYRO_FAILED_BEFORE_CONTROL_CHOICE;
    case timing_fault_before_control: return CANARD_BUS_STATUS_REPORT_REASON_TIMING_FAULT_BEFORE_CONTROL_CHOICE;
    case control_time_over: return CANARD_BUS_STATUS_REPORT_REASON_CONTROL_TIME_OVER_CHOICE;
    case apogee: return CANARD_BUS_STATUS_REPORT_REASON_APOGEE_CHOICE;
    case tilted_too_far: return CANARD_BUS_STATUS_REPORT_REASON_TILTED_TOO_FAR_CHOICE;
    case gyro_failed: return CANARD_BUS_STATUS_REPORT_REASON_GYRO_FAILED_CHOICE;
    case timing_fault: return CANARD_BUS_STATUS_REPORT_REASON_TIMING_FAULT_CHOICE;
    case canard_fault: return CANARD_BUS_STATUS_REPORT_REASON_CANARD_FAULT_CHOICE;
    case memory_fault: return CANARD_BUS_STATUS_REPORT_REASON_MEMORY_FAULT_CHOICE;
    case moved_without_launch: return CANARD_BUS_STATUS_REPORT_REASON_MOVED_WITHOUT_LAUNCH_CHOICE;
    case rested: return CANARD_BUS_STATUS_REPORT_REASON_RESTED_CHOICE;
    case flew_without_launch: return CANARD_BUS_STATUS_REPORT_REASON_FLEW_WITHOUT_LAUNCH_CHOICE;
    case gate_open: return CANARD_BUS_STATUS_REPORT_REASON_GATE_OPEN_CHOICE;
    case gate_closed_again: return CANARD_BUS_STATUS_REPORT_REASON_GATE_CLOSED_AGAIN_CHOICE;
    case gate_never_opened: return CANARD_BUS_STATUS_REPORT_REASON_GATE_NEVER_OPENED_CHOICE;
    case aborted: return CANARD_BUS_STATUS_REPORT_REASON_ABORTED_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(core::CommandStatus value) {
  switch (value) {
    using enum core::CommandStatus;
    case outside_control: return CANARD_BUS_STATUS_REPORT_COMMAND_STATUS_OUTSIDE_CONTROL_CHOICE;
    case controlling: return CANARD_BUS_STATUS_REPORT_COMMAND_STATUS_CONTROLLING_CHOICE;
    case gyro_lost: return CANARD_BUS_STATUS_REPORT_COMMAND_STATUS_GYRO_LOST_CHOICE;
    case not_finite: return CANARD_BUS_STATUS_REPORT_COMMAND_STATUS_NOT_FINITE_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(core::CanardVerdict value) {
  switch (value) {
    using enum core::CanardVerdict;
    case healthy: return CANARD_BUS_HEALTH_REPORT_VERDICT_1_HEALTHY_CHOICE;
    case dead: return CANARD_BUS_HEALTH_REPORT_VERDICT_1_DEAD_CHOICE;
    case stalled: return CANARD_BUS_HEALTH_REPORT_VERDICT_1_STALLED_CHOICE;
    case slipping: return CANARD_BUS_HEALTH_REPORT_VERDICT_1_SLIPPING_CHOICE;
    case disagreeing: return CANARD_BUS_HEALTH_REPORT_VERDICT_1_DISAGREEING_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(core::SensorState value) {
  switch (value) {
    using enum core::SensorState;
    case fresh: return CANARD_BUS_HEALTH_REPORT_GYRO_FRESH_CHOICE;
    case coasting: return CANARD_BUS_HEALTH_REPORT_GYRO_COASTING_CHOICE;
    case lost: return CANARD_BUS_HEALTH_REPORT_GYRO_LOST_CHOICE;
    case failed: return CANARD_BUS_HEALTH_REPORT_GYRO_FAILED_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(core::SampleQuality value) {
  switch (value) {
    using enum core::SampleQuality;
    case valid: return CANARD_BUS_GYRO_REPORT_QUALITY_VALID_CHOICE;
    case saturated: return CANARD_BUS_GYRO_REPORT_QUALITY_SATURATED_CHOICE;
    case invalid: return CANARD_BUS_GYRO_REPORT_QUALITY_INVALID_CHOICE;
    case absent: return CANARD_BUS_GYRO_REPORT_QUALITY_ABSENT_CHOICE;
  }
  return no_choice;
}

/// Whether every enumerator's value is that of its choice in the database.
template <typename Enum>
consteval bool choices_agree() {
  for (unsigned value = 0; value < no_choice; ++value) {
    const unsigned found = choice(static_cast<Enum>(value));
    if (found != value && found != no_choice) {
      return false;
    }
  }
  return true;
}

static_assert(choices_agree<core::Phase>());
static_assert(choices_agree<core::PhaseReason>());
static_assert(choices_agree<core::CommandStatus>());
static_assert(choices_agree<core::CanardVerdict>());
static_assert(choices_agree<core::SensorState>());
static_assert(choices_agree<core::SampleQuality>());

}  // namespace fantail::protocol
