// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::listen {

/// What can be heard in a log. Body frame of the flight law: x to the nose, y and z to the sides, right-handed.
enum class Quantity : std::uint8_t {
  time,
  axial,         ///< specific force along x: +1 g on the pad
  second_axial,  ///< the same by a second accelerometer
  lateral_y,     ///< specific force along y
  lateral_z,
  roll_rate,   ///< about x
  pitch_rate,  ///< about y
  yaw_rate,    ///< about z
  height,      ///< the log's own, for comparison: the law never sees it
  speed,       ///< likewise
};
inline constexpr std::size_t quantities = 10;

[[nodiscard]] std::string_view name(Quantity quantity);

/// Which column of a log is what.
struct Source {
  Quantity quantity{};
  std::string column{};    ///< its name in the file
  std::string unit{};      ///< in the file
  double factor = 1.0;     ///< what a figure of the file is multiplied with: sign, scale and unit, to SI and radians
  bool from_rest = false;  ///< reads zero on the pad, so that 1 g is added
  bool must_be_there = true;
  std::string words{};  ///< as the person wrote it: "-Ay:m/s2"
};
using Sources = std::vector<Source>;

/// "time=ts:s,axial=-Ay:m/s2,height=0.3048*alt:m": QUANTITY=[-][SCALE*]COLUMN:UNIT, several with commas between. The
/// quantities are those above and axial_from_rest, second_axial_from_rest: a force whose zero is the pad. `option` is
/// named in messages. Throws text::Error (bad_configuration) for an unknown quantity or unit, one that is missing or
/// of another dimension (naming those allowed), a scale that is no number or zero, a quantity twice.
[[nodiscard]] Sources parse_columns(std::string_view text, const std::string& option);

/// What both say, and where they disagree the first.
[[nodiscard]] Sources merged(const Sources& first, const Sources& second);

[[nodiscard]] const Source* find(const Sources& sources, Quantity quantity);

}  // namespace fantail::listen
