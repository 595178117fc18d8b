// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/flight_plan_fields.hpp"
#include "input/document.hpp"
#include "input/section.hpp"

namespace fantail::input {

/// Reads a flight plan (TOML) through the core's table of fields: what is not in the file keeps its default, what the
/// table does not know or does not allow is refused. A per-canard field takes one value for all four or a list of four.
/// Throws text::Error.
[[nodiscard]] core::FlightPlan read_plan(const Document& document);

/// `plan` with some of its values changed, read and checked as from a file; every other value keeps all its bits.
/// Throws text::Error (bad_configuration).
[[nodiscard]] core::FlightPlan changed_plan(const core::FlightPlan& plan, std::span<const Override> changes);

/// One line a field: section, key, value in file units, unit, allowed range, meaning.
[[nodiscard]] std::string plan_table(const core::FlightPlan& plan);

/// What a file that holds plan_table() says, value by value.
[[nodiscard]] Document plan_document(const core::FlightPlan& plan);

/// Whether a file that holds plan_table() is this plan again, bit for bit. It is for every plan that was made from a
/// file.
[[nodiscard]] bool table_says_all(const core::FlightPlan& plan);

/// The range and the default of a number, in the file's unit.
[[nodiscard]] Limits allowed_in_plan(const core::PlanField& field);
[[nodiscard]] double usual_in_plan(const core::PlanField& field);

/// The names of the plan's sections.
[[nodiscard]] std::vector<std::string> plan_sections();

}  // namespace fantail::input
