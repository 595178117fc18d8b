// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flight/table.hpp"

namespace fantail::trajectory {

/// What a column of an exported trajectory holds.
enum class Quantity : std::uint8_t {
  time,
  height,  ///< above the launch site
  height_above_sea,
  speed,  ///< over ground, as the next four
  up,
  across,  ///< horizontally, not negative
  east,
  north,
  air_speed,
  angle_of_attack,
  density,
  temperature,
  pressure,
  elevation,          ///< of the axis above the horizon: 90 deg is upright
  axial_acceleration  ///< change of the velocity along the axis; at rest zero
};

/// A column and how its numbers become SI: value * scale + offset.
struct FoundColumn {
  Quantity quantity;
  std::size_t index;
  std::string name;  ///< as in the file, without the unit
  double scale;
  double offset;
  double least;  ///< in SI, as the next: what a rocket can have
  double most;
};

/// The columns of a table that mean something here, one for each quantity. Names are those that OpenRocket 15 to 24 and
/// RocketPy 1.9 to 1.10 write, in capitals or not, the unit in parentheses behind them.
class Columns {
 public:
  /// Throws text::Error (bad_data), with file, line and column: a unit that nobody knows.
  explicit Columns(const flight::Table& table);

  [[nodiscard]] const FoundColumn* find(Quantity quantity) const;
  [[nodiscard]] bool has(Quantity quantity) const { return find(quantity) != nullptr; }
  [[nodiscard]] const std::vector<FoundColumn>& all() const { return found_; }

 private:
  std::vector<FoundColumn> found_;
};

/// In a sentence: "height above the sea".
[[nodiscard]] std::string_view word(Quantity quantity);

/// How both programs call it: "Altitude (OpenRocket) or Altitude AGL (RocketPy, altitude)".
[[nodiscard]] std::string names_of(Quantity quantity);

}  // namespace fantail::trajectory
