// SPDX-License-Identifier: MIT
#pragma once

#include "protocol/bus_choices.hpp"

namespace fantail::protocol {

// Inside the codec only: the choices of the frames that download and erase the flight record.

constexpr unsigned choice(LogAction value) {
  switch (value) {
    using enum LogAction;
    case info: return CANARD_BUS_LOG_REQUEST_ACTION_INFO_CHOICE;
    case read: return CANARD_BUS_LOG_REQUEST_ACTION_READ_CHOICE;
    case erase: return CANARD_BUS_LOG_REQUEST_ACTION_ERASE_CHOICE;
    case plan: return CANARD_BUS_LOG_REQUEST_ACTION_PLAN_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(LogState value) {
  switch (value) {
    using enum LogState;
    case ready: return CANARD_BUS_LOG_REPLY_STATE_READY_CHOICE;
    case read: return CANARD_BUS_LOG_REPLY_STATE_READ_CHOICE;
    case erasing: return CANARD_BUS_LOG_REPLY_STATE_ERASING_CHOICE;
    case erased: return CANARD_BUS_LOG_REPLY_STATE_ERASED_CHOICE;
    case refused: return CANARD_BUS_LOG_REPLY_STATE_REFUSED_CHOICE;
  }
  return no_choice;
}

constexpr unsigned choice(LogFault value) {
  switch (value) {
    using enum LogFault;
    case none: return CANARD_BUS_LOG_REPLY_FAULT_NONE_CHOICE;
    case not_safe: return CANARD_BUS_LOG_REPLY_FAULT_NOT_SAFE_CHOICE;
    case no_session: return CANARD_BUS_LOG_REPLY_FAULT_NO_SESSION_CHOICE;
    case busy: return CANARD_BUS_LOG_REPLY_FAULT_BUSY_CHOICE;
    case not_counted_yet: return CANARD_BUS_LOG_REPLY_FAULT_NOT_COUNTED_YET_CHOICE;
    case out_of_range: return CANARD_BUS_LOG_REPLY_FAULT_OUT_OF_RANGE_CHOICE;
    case flash_failed: return CANARD_BUS_LOG_REPLY_FAULT_FLASH_FAILED_CHOICE;
  }
  return no_choice;
}

static_assert(choices_agree<LogAction>());
static_assert(choices_agree<LogState>());
static_assert(choices_agree<LogFault>());

}  // namespace fantail::protocol
