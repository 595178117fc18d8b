// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
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
/// Superscripts as digits, the sign of degrees as a word and "sec" as s, from UTF-8 or Latin-1: "m/s2", "degC".
[[nodiscard]] std::string plainly_spelt(std::string_view unit);

/// The dictionary of what columns hold: every quantity once, with its dimension, the column of Fantail's own files, and
/// what other programs call it.

/// Body frame of the flight law: x to the nose, y and z to the sides, right-handed. The numbers of flight.csv come
/// first, in its order.
enum class Quantity : std::uint8_t {
  time,
  phase,  ///< words
  roll_angle,
  roll_rate,  ///< about x
  reference,
  excitation,
  offset_estimate,
  command,
  saturated,
  command_1,
  command_2,
  command_3,
  command_4,
  encoder_1,
  encoder_2,
  encoder_3,
  encoder_4,
  canard,
  axial,   ///< specific force along x: +1 g on the pad
  height,  ///< above the launch site
  speed,
  disturbance,  ///< of the true_ columns alone, as the next
  geometric_roll,
  second_axial,  ///< the same force by a second accelerometer
  lateral_y,     ///< specific force along y
  lateral_z,
  pitch_rate,  ///< about y
  yaw_rate,    ///< about z
  pitch,
  fan,  ///< set point of a tunnel's fan, revolutions a minute
  wind_speed,
  height_above_the_sea,
  total_speed,  ///< over ground, as the next four
  vertical_speed,
  horizontal_speed,  ///< not negative
  speed_to_the_east,
  speed_to_the_north,
  air_speed,
  angle_of_attack,
  air_density,
  temperature,
  pressure,
  tilt,                        ///< elevation of the axis: 90 deg is upright
  acceleration_along_the_axis  ///< change of the velocity; at rest zero
};

/// Those that flight.csv has.
inline constexpr auto of_flight_csv = [] {
  std::array<Quantity, static_cast<std::size_t>(Quantity::speed) + 1> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = static_cast<Quantity>(i);
  }
  return all;
}();

struct KnownQuantity {
  std::string_view name;  ///< as a person says it
  Quantity quantity;
  std::optional<Dimension> dimension;  ///< none: words, flags and counts
  std::string_view column{};           ///< of Fantail's own files, in own_unit(); empty: they do not have it
  bool from_rest = false;              ///< reads zero on the pad, so that 1 g is added
};

/// A quantity may stand here under several names, first under its own.
[[nodiscard]] std::span<const KnownQuantity> known_quantities();
[[nodiscard]] const KnownQuantity& known(Quantity quantity);
/// By its column in Fantail's own files; null for one that is none of these.
[[nodiscard]] const KnownQuantity* of_own_column(std::string_view column);
/// In a sentence: "height above the sea".
[[nodiscard]] std::string word(Quantity quantity);

/// What a simulator calls a quantity; the unit stands in parentheses behind it.
struct ExportedColumn {
  std::string_view name;
  Quantity quantity;
  std::string_view writer;
  std::string_view languages{};  ///< in which it writes so, with spaces between; empty: English
};
/// Those that OpenRocket 15 to 24 in its languages, RocketPy 1.9 to 1.10 and RASAero II write. Of two that hold the
/// same the first is taken.
[[nodiscard]] std::span<const ExportedColumn> exported_columns();

}  // namespace fantail::files
