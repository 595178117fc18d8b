// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "protocol/bus_core_choices.hpp"
#include "protocol/bus_messages.hpp"
#include "protocol/generated/canard_bus.h"

namespace fantail::protocol {

// Inside the codec only, as bus_core_choices.hpp: the choices of what the bus alone knows.

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
    case second_gyro_failed: return CANARD_BUS_ARM_REPLY_FAILURE_SECOND_GYRO_FAILED_CHOICE;
    case gyros_disagree: return CANARD_BUS_ARM_REPLY_FAILURE_GYROS_DISAGREE_CHOICE;
    case gyro_turns: return CANARD_BUS_ARM_REPLY_FAILURE_GYRO_TURNS_CHOICE;
    case second_gyro_turns: return CANARD_BUS_ARM_REPLY_FAILURE_SECOND_GYRO_TURNS_CHOICE;
    case barometer_failed: return CANARD_BUS_ARM_REPLY_FAILURE_BAROMETER_FAILED_CHOICE;
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
    case abort_not_ready: return CANARD_BUS_ARM_REPLY_REFUSAL_ABORT_NOT_READY_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(AbortState value) {
  switch (value) {
    using enum AbortState;
    case none_fitted: return CANARD_BUS_ARM_REPLY_ABORT_INPUT_NONE_FITTED_CHOICE;
    case ready: return CANARD_BUS_ARM_REPLY_ABORT_INPUT_READY_CHOICE;
    case asks_to_abort: return CANARD_BUS_ARM_REPLY_ABORT_INPUT_ASKS_TO_ABORT_CHOICE;
    case unsettled: return CANARD_BUS_ARM_REPLY_ABORT_INPUT_UNSETTLED_CHOICE;
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

constexpr unsigned choice(Accelerometer value) {
  switch (value) {
    using enum Accelerometer;
    case of_imu: return CANARD_BUS_ACCELEROMETER_REPORT_SENSOR_OF_IMU_CHOICE;
    case second: return CANARD_BUS_ACCELEROMETER_REPORT_SENSOR_SECOND_CHOICE;
  }
  return no_choice;
}

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
