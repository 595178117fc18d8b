// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "json/value.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::bench {

/// The names of docs/can.md; "bit_31" for one that only newer avionics knows.
[[nodiscard]] std::vector<std::string> fault_names(std::uint32_t faults);

/// "no fault; reset by power-on, battery not measured, 0 control ticks missed"
[[nodiscard]] std::string board_text(const protocol::BoardReport& report);

/// Each fault of board, flash or stored plan with which the avionics does not arm, in the words of docs/can.md.
[[nodiscard]] std::vector<std::string> bars_to_arming(const protocol::BoardReport& report);

/// Puts board_faults, reset_cause, battery_v, ticks_missed, plan_source and flash_failed into an object; all null when
/// the board has not reported. `plan_key`: the name of plan_source there.
void add_board(json::Value& to, const std::optional<protocol::BoardReport>& report, const char* plan_key);

}  // namespace fantail::bench
