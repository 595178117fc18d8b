// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/flight_plan.hpp"
#include "sim/document.hpp"

namespace fantail::sim {

/// Reads a flight plan (TOML) through the core's table of fields: what is not in the file keeps its default, what the
/// table does not know or does not allow is refused. A per-canard field takes one value for all four or a list of four.
/// Throws InputError.
[[nodiscard]] core::FlightPlan read_plan(const Document& document);

/// One line a field: section, key, value in file units, unit, allowed range, meaning.
[[nodiscard]] std::string plan_table(const core::FlightPlan& plan);

/// The names of the plan's sections.
[[nodiscard]] std::vector<std::string> plan_sections();

}  // namespace fantail::sim
