// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace fantail::flight {

enum class Dimension : std::uint8_t { time, angle, angular_rate, length, speed, acceleration };

/// A unit that a column of another logger may be in.
struct Unit {
  std::string_view name;
  Dimension dimension;
  double si;  ///< one of it in SI and radians
};

[[nodiscard]] std::span<const Unit> units();
/// Null for a name that is no unit.
[[nodiscard]] const Unit* find_unit(std::string_view name);
/// "deg/s, rad/s, ...".
[[nodiscard]] std::string unit_names(Dimension dimension);

/// What a column of flight.csv is called without its unit, and what it measures: roll_rate_deg_s is roll_rate, an
/// angular rate. No dimension: words, or 0 and 1.
struct Quantity {
  std::string_view name;
  std::optional<Dimension> dimension;
};
[[nodiscard]] Quantity quantity_of(std::string_view column);

}  // namespace fantail::flight
