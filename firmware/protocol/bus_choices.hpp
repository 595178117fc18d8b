// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "protocol/bus_messages.hpp"
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

constexpr unsigned choice(SessionAction value) {
  switch (value) {
    using enum SessionAction;
    case keep: return CANARD_BUS_BENCH_SESSION_ACTION_KEEP_CHOICE;
    case open: return CANARD_BUS_BENCH_SESSION_ACTION_OPEN_CHOICE;
    case close: return CANARD_BUS_BENCH_SESSION_ACTION_CLOSE_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(ArmAction value) {
  switch (value) {
    using enum ArmAction;
    case self_test: return CANARD_BUS_ARM_REQUEST_ACTION_SELF_TEST_CHOICE;
    case begin: return CANARD_BUS_ARM_REQUEST_ACTION_BEGIN_CHOICE;
    case confirm: return CANARD_BUS_ARM_REQUEST_ACTION_CONFIRM_CHOICE;
    case start: return CANARD_BUS_ARM_REQUEST_ACTION_START_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(SessionState value) {
  switch (value) {
    using enum SessionState;
    case closed: return CANARD_BUS_SESSION_REPLY_STATE_CLOSED_CHOICE;
    case open: return CANARD_BUS_SESSION_REPLY_STATE_OPEN_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(SessionReason value) {
  switch (value) {
    using enum SessionReason;
    case none_yet: return CANARD_BUS_SESSION_REPLY_REASON_NONE_YET_CHOICE;
    case opened: return CANARD_BUS_SESSION_REPLY_REASON_OPENED_CHOICE;
    case closed_by_bench: return CANARD_BUS_SESSION_REPLY_REASON_CLOSED_BY_BENCH_CHOICE;
    case heartbeat_lost: return CANARD_BUS_SESSION_REPLY_REASON_HEARTBEAT_LOST_CHOICE;
    case not_safe: return CANARD_BUS_SESSION_REPLY_REASON_NOT_SAFE_CHOICE;
    case not_at_rest: return CANARD_BUS_SESSION_REPLY_REASON_NOT_AT_REST_CHOICE;
    case self_test_runs: return CANARD_BUS_SESSION_REPLY_REASON_SELF_TEST_RUNS_CHOICE;
    case other_session: return CANARD_BUS_SESSION_REPLY_REASON_OTHER_SESSION_CHOICE;
    case number_too_similar: return CANARD_BUS_SESSION_REPLY_REASON_NUMBER_TOO_SIMILAR_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(SelfTestState value) {
  switch (value) {
    using enum SelfTestState;
    case not_run: return CANARD_BUS_ARM_REPLY_SELF_TEST_NOT_RUN_CHOICE;
    case running: return CANARD_BUS_ARM_REPLY_SELF_TEST_RUNNING_CHOICE;
    case passed: return CANARD_BUS_ARM_REPLY_SELF_TEST_PASSED_CHOICE;
    case failed: return CANARD_BUS_ARM_REPLY_SELF_TEST_FAILED_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(SelfTestFailure value) {
  switch (value) {
    using enum SelfTestFailure;
    case none: return CANARD_BUS_ARM_REPLY_FAILURE_NONE_CHOICE;
    case not_safe: return CANARD_BUS_ARM_REPLY_FAILURE_NOT_SAFE_CHOICE;
    case moved: return CANARD_BUS_ARM_REPLY_FAILURE_MOVED_CHOICE;
    case gyro_failed: return CANARD_BUS_ARM_REPLY_FAILURE_GYRO_FAILED_CHOICE;
    case accelerometer_failed: return CANARD_BUS_ARM_REPLY_FAILURE_ACCELEROMETER_FAILED_CHOICE;
    case specific_force_not_one_g: return CANARD_BUS_ARM_REPLY_FAILURE_SPECIFIC_FORCE_NOT_ONE_G_CHOICE;
    case accelerometers_disagree: return CANARD_BUS_ARM_REPLY_FAILURE_ACCELEROMETERS_DISAGREE_CHOICE;
    case encoder_silent: return CANARD_BUS_ARM_REPLY_FAILURE_ENCODER_SILENT_CHOICE;
    case canard_did_not_follow: return CANARD_BUS_ARM_REPLY_FAILURE_CANARD_DID_NOT_FOLLOW_CHOICE;
    case another_canard_moved: return CANARD_BUS_ARM_REPLY_FAILURE_ANOTHER_CANARD_MOVED_CHOICE;
    case no_valid_plan: return CANARD_BUS_ARM_REPLY_FAILURE_NO_VALID_PLAN_CHOICE;
    case flash_failed: return CANARD_BUS_ARM_REPLY_FAILURE_FLASH_FAILED_CHOICE;
    case flash_too_full: return CANARD_BUS_ARM_REPLY_FAILURE_FLASH_TOO_FULL_CHOICE;
    case timed_out: return CANARD_BUS_ARM_REPLY_FAILURE_TIMED_OUT_CHOICE;
    case board_fault: return CANARD_BUS_ARM_REPLY_FAILURE_BOARD_FAULT_CHOICE;
    case newer_plan: return CANARD_BUS_ARM_REPLY_FAILURE_NEWER_PLAN_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(ArmRefusal value) {
  switch (value) {
    using enum ArmRefusal;
    case none: return CANARD_BUS_ARM_REPLY_REFUSAL_NONE_CHOICE;
    case not_safe: return CANARD_BUS_ARM_REPLY_REFUSAL_NOT_SAFE_CHOICE;
    case session_open: return CANARD_BUS_ARM_REPLY_REFUSAL_SESSION_OPEN_CHOICE;
    case self_test_not_passed: return CANARD_BUS_ARM_REPLY_REFUSAL_SELF_TEST_NOT_PASSED_CHOICE;
    case switch_not_cycled: return CANARD_BUS_ARM_REPLY_REFUSAL_SWITCH_NOT_CYCLED_CHOICE;
    case switch_open: return CANARD_BUS_ARM_REPLY_REFUSAL_SWITCH_OPEN_CHOICE;
    case not_at_rest: return CANARD_BUS_ARM_REPLY_REFUSAL_NOT_AT_REST_CHOICE;
    case no_nonce: return CANARD_BUS_ARM_REPLY_REFUSAL_NO_NONCE_CHOICE;
    case nonce_expired: return CANARD_BUS_ARM_REPLY_REFUSAL_NONCE_EXPIRED_CHOICE;
    case wrong_nonce: return CANARD_BUS_ARM_REPLY_REFUSAL_WRONG_NONCE_CHOICE;
    case not_a_tunnel_plan: return CANARD_BUS_ARM_REPLY_REFUSAL_NOT_A_TUNNEL_PLAN_CHOICE;
    case not_armed: return CANARD_BUS_ARM_REPLY_REFUSAL_NOT_ARMED_CHOICE;
    case board_fault: return CANARD_BUS_ARM_REPLY_REFUSAL_BOARD_FAULT_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(TransferState value) {
  switch (value) {
    using enum TransferState;
    case idle: return CANARD_BUS_PLAN_REPLY_STATE_IDLE_CHOICE;
    case receiving: return CANARD_BUS_PLAN_REPLY_STATE_RECEIVING_CHOICE;
    case writing: return CANARD_BUS_PLAN_REPLY_STATE_WRITING_CHOICE;
    case stored: return CANARD_BUS_PLAN_REPLY_STATE_STORED_CHOICE;
    case refused: return CANARD_BUS_PLAN_REPLY_STATE_REFUSED_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(TransferFault value) {
  switch (value) {
    using enum TransferFault;
    case none: return CANARD_BUS_PLAN_REPLY_FAULT_NONE_CHOICE;
    case not_safe: return CANARD_BUS_PLAN_REPLY_FAULT_NOT_SAFE_CHOICE;
    case wrong_size: return CANARD_BUS_PLAN_REPLY_FAULT_WRONG_SIZE_CHOICE;
    case out_of_order: return CANARD_BUS_PLAN_REPLY_FAULT_OUT_OF_ORDER_CHOICE;
    case timed_out: return CANARD_BUS_PLAN_REPLY_FAULT_TIMED_OUT_CHOICE;
    case bad_block: return CANARD_BUS_PLAN_REPLY_FAULT_BAD_BLOCK_CHOICE;
    case flash_failed: return CANARD_BUS_PLAN_REPLY_FAULT_FLASH_FAILED_CHOICE;
    case read_back_differs: return CANARD_BUS_PLAN_REPLY_FAULT_READ_BACK_DIFFERS_CHOICE;
  }
  return no_choice;
}

/// On the bus zero is the absence of a fault, so every fault stands one higher.
constexpr unsigned choice(PlanBlockFault value) {
  switch (value) {
    using enum PlanBlockFault;
    case too_short: return CANARD_BUS_PLAN_REPLY_BLOCK_FAULT_TOO_SHORT_CHOICE - 1;
    case no_plan_block: return CANARD_BUS_PLAN_REPLY_BLOCK_FAULT_NO_PLAN_BLOCK_CHOICE - 1;
    case wrong_length: return CANARD_BUS_PLAN_REPLY_BLOCK_FAULT_WRONG_LENGTH_CHOICE - 1;
    case wrong_checksum: return CANARD_BUS_PLAN_REPLY_BLOCK_FAULT_WRONG_CHECKSUM_CHOICE - 1;
    case older_version: return CANARD_BUS_PLAN_REPLY_BLOCK_FAULT_OLDER_VERSION_CHOICE - 1;
    case other_schema: return CANARD_BUS_PLAN_REPLY_BLOCK_FAULT_OTHER_SCHEMA_CHOICE - 1;
    case refused: return CANARD_BUS_PLAN_REPLY_BLOCK_FAULT_REFUSED_CHOICE - 1;
    case newer_version: return CANARD_BUS_PLAN_REPLY_BLOCK_FAULT_NEWER_VERSION_CHOICE - 1;
  }
  return no_choice;
}

constexpr unsigned choice(PlanSource value) {
  switch (value) {
    using enum PlanSource;
    case built_in: return CANARD_BUS_BOARD_REPORT_PLAN_BUILT_IN_CHOICE;
    case stored: return CANARD_BUS_BOARD_REPORT_PLAN_STORED_CHOICE;
    case stored_is_broken: return CANARD_BUS_BOARD_REPORT_PLAN_STORED_IS_BROKEN_CHOICE;
    case stored_is_newer: return CANARD_BUS_BOARD_REPORT_PLAN_STORED_IS_NEWER_CHOICE;
    case flash_unreadable: return CANARD_BUS_BOARD_REPORT_PLAN_FLASH_UNREADABLE_CHOICE;
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

constexpr unsigned choice(Accelerometer value) {
  switch (value) {
    using enum Accelerometer;
    case of_imu: return CANARD_BUS_ACCELEROMETER_REPORT_SENSOR_OF_IMU_CHOICE;
    case second: return CANARD_BUS_ACCELEROMETER_REPORT_SENSOR_SECOND_CHOICE;
  }
  return no_choice;
}

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
static_assert(choices_agree<SessionAction>());
static_assert(choices_agree<ArmAction>());
static_assert(choices_agree<SessionState>());
static_assert(choices_agree<SessionReason>());
static_assert(choices_agree<SelfTestState>());
static_assert(choices_agree<SelfTestFailure>());
static_assert(choices_agree<ArmRefusal>());
static_assert(choices_agree<TransferState>());
static_assert(choices_agree<TransferFault>());
static_assert(choices_agree<PlanBlockFault>());
static_assert(choices_agree<PlanSource>());
static_assert(choices_agree<core::CanardVerdict>());
static_assert(choices_agree<core::SensorState>());
static_assert(choices_agree<core::SampleQuality>());
static_assert(choices_agree<Accelerometer>());
static_assert(CANARD_BUS_HEALTH_REPORT_BUS_STATE_ERROR_ACTIVE_CHOICE == 0);
static_assert(CANARD_BUS_HEALTH_REPORT_BUS_STATE_ERROR_WARNING_CHOICE == 1);
static_assert(CANARD_BUS_HEALTH_REPORT_BUS_STATE_ERROR_PASSIVE_CHOICE == 2);
static_assert(CANARD_BUS_HEALTH_REPORT_BUS_STATE_BUS_OFF_CHOICE == 3);
static_assert(CANARD_BUS_HEALTH_REPORT_BUS_STATE_DOWN_CHOICE == 4);
static_assert(CANARD_BUS_BOARD_REPORT_RESET_CAUSE_POWER_ON_CHOICE == 0);
static_assert(CANARD_BUS_BOARD_REPORT_RESET_CAUSE_BROWN_OUT_CHOICE == 1);
static_assert(CANARD_BUS_BOARD_REPORT_RESET_CAUSE_PIN_CHOICE == 2);
static_assert(CANARD_BUS_BOARD_REPORT_RESET_CAUSE_SOFTWARE_CHOICE == 3);
static_assert(CANARD_BUS_BOARD_REPORT_RESET_CAUSE_WATCHDOG_CHOICE == 4);

/// Empty for a value that is no choice.
template <typename Enum>
[[nodiscard]] constexpr std::optional<Enum> known(std::uint8_t raw) {
  const auto value = static_cast<Enum>(raw);
  return choice(value) == no_choice ? std::nullopt : std::optional{value};
}

template <typename Enum>
[[nodiscard]] constexpr std::uint8_t raw_of(Enum value) {
  return static_cast<std::uint8_t>(value);
}

}  // namespace fantail::protocol
