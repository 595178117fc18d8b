// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/bus_messages.hpp"

namespace fantail::bench {

/// By the names of docs/can.md; "bit_20" for one that only newer avionics knows.
[[nodiscard]] std::vector<std::string> fault_names(std::uint32_t faults);

/// The words of the database, for a program.
[[nodiscard]] std::string_view reset_cause_name(const protocol::BoardReport& report);
[[nodiscard]] std::string_view name(protocol::PlanSource plan);

/// Two or three lines for a person, each with its end.
[[nodiscard]] std::string board_lines(const protocol::BoardReport& report);

}  // namespace fantail::bench
