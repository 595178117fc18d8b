// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fantail::files {

enum class Dimension : std::uint8_t {
  time,
  angle,
  angular_rate,
  length,
  speed,
  acceleration,
  density,
  temperature,
  pressure
};

/// A unit that a column of another program may be in: value * si + offset is in SI and radians.
struct Unit {
  std::string_view name;
  Dimension dimension;
  double si;
  double offset = 0.0;
};

/// Null for a name that is no unit.
[[nodiscard]] const Unit* find_unit(std::string_view name);
/// The one that Fantail's own files have it in: deg/s.
[[nodiscard]] const Unit& own_unit(Dimension dimension);
/// "deg/s, rad/s, ...".
[[nodiscard]] std::string unit_names(Dimension dimension);
/// Superscripts as digits and the sign of degrees as a word, from UTF-8 or Latin-1: "m/s2", "degC".
[[nodiscard]] std::string plainly_spelt(std::string_view unit);

}  // namespace fantail::files
