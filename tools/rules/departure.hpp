// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "flight/flight.hpp"
#include "rules/expression.hpp"

namespace fantail::rules {

/// A command this far from trim moves a canard; its shaft has the play of a gear on top (flight/trim.hpp).
inline constexpr double command_tolerance_deg = 0.1;

/// The first canard that leaves trim, as far as commands and canard_rad() show it.
struct Departure {
  double since_s = 0.0;              ///< all canards at trim from here on, the beginning of the rows at the earliest
  double until_s = 0.0;              ///< up to here: the departure, or the end
  std::optional<double> time_s{};    ///< empty: none was seen
  flight::Row row{};                 ///< then
  std::string what{};                ///< "command of canard 2"
  double largest_command_deg = 0.0;  ///< from trim, in that time
  double largest_angle_deg = 0.0;
  bool by_truth = false;  ///< the angles are those of the shafts, and not those of encoders
  /// From here on, before the departure, canard_rad() is empty or rows are missing: nobody saw a canard.
  std::optional<double> hidden_from_s{};
  flight::Row hidden_row{};
};

[[nodiscard]] double height_m(const flight::Row& row);  ///< true where that is known
/// The true one, or as far as an accelerometer tells it.
[[nodiscard]] Number height_range_m(const flight::Row& row);
[[nodiscard]] double speed_m_s(const flight::Row& row);

/// Where the shaft of a canard truly stands; where that is not known, by its encoder; empty: that is silent.
[[nodiscard]] std::optional<double> canard_rad(const flight::Row& row, std::size_t canard);

/// By the command of a canard, beyond the tolerance.
[[nodiscard]] bool is_commanded_away(const flight::Row& row, const core::FlightPlan& plan);

/// "command of canard 2": one that is away from trim in this row; empty: none.
[[nodiscard]] std::string who_is_away(const flight::Row& row, const core::FlightPlan& plan);

/// From here on, between these times, canard_rad() is empty or rows are missing: nobody saw the canards.
[[nodiscard]] std::optional<double> silent_from_s(std::span<const flight::Row> rows, double from_s, double to_s);

/// `rows` up to the end of the ascent; what happens before `from_s`, lift-off or later, is none. The trims are those of
/// the plan.
[[nodiscard]] Departure departure(std::span<const flight::Row> rows, const core::FlightPlan& plan, double from_s = 0.0);

/// "from -2.41 to 3.53 s, commands within 0.1 deg and encoders within 0.14 deg of trim"
[[nodiscard]] std::string departure_text(const Departure& found);

}  // namespace fantail::rules
