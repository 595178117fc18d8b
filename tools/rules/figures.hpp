// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/flight_plan.hpp"
#include "flight/flight.hpp"
#include "rules/expression.hpp"
#include "sim/scenario.hpp"

// What an expression of a clause may name, beside the pack's own words: law.*, flight.*, rocket.* and plan.SECTION.KEY.
namespace fantail::rules {

/// A figure that is computed from a flight, a rocket or the flight law.
struct FigureText {
  std::string_view name;
  Type type;
  std::string_view unit;
  int decimals;
  std::string_view meaning;  ///< a clause
};
[[nodiscard]] std::span<const FigureText> figure_texts();
/// Null: there is no figure of this name.
[[nodiscard]] const FigureText* find_figure(std::string_view name);

/// What is known of a name, and how: a clause, or why it is unknown.
struct Finding {
  std::optional<Known> known{};
  std::string how{};
};
using Findings = std::map<std::string, Finding, std::less<>>;

/// "plan.SECTION.KEY" of every field of a plan. Of a field with several values a number reaches from the least to the
/// largest, and a word or a flag is unknown where they differ.
[[nodiscard]] std::map<std::string, Meaning> plan_meanings();
[[nodiscard]] Findings of_plan(const core::FlightPlan& plan);

/// law.*: they follow from the program, whatever the plan.
[[nodiscard]] Findings of_law();

/// flight.* of a launch that was simulated; `atmosphere` is the one that it was flown in. The true motion counts.
[[nodiscard]] Findings of_flight(const flight::Flight& flight, const sim::Atmosphere& atmosphere);

/// flight.* of a record, in the standard atmosphere. What may have happened in a hole of its rows is unknown, or known
/// only to one side. Unknown all of them where no launch was detected in it. `motor_burns_s`: how long by its thrust
/// curve; empty: unknown, and so is burn-out.
[[nodiscard]] Findings of_log(const flight::Flight& log, const std::optional<double>& motor_burns_s = {});

/// rocket.* of a scenario and its flight.
[[nodiscard]] Findings of_rocket(const sim::Scenario& scenario, const flight::Flight& flight);
/// rocket.* of the vehicle that flew this log: `found` has what of_log() says of it. `side_moment_m3` as
/// flight::Flight has it.
[[nodiscard]] Findings of_rocket(const sim::Vehicle& vehicle, std::optional<double> side_moment_m3,
                                 const Findings& found);

/// "0.64 s", "3.1 s or more", "yes", "burn_out", "not known".
[[nodiscard]] std::string value_text(std::string_view name, const std::optional<Known>& known);

}  // namespace fantail::rules
