// SPDX-License-Identifier: MIT
#include "trajectory/columns.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>
#include <string_view>

#include <fmt/core.h>

#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::trajectory {
namespace {

enum class Dimension : std::uint8_t { time, length, speed, acceleration, angle, density, temperature, pressure };

struct Unit {
  std::string_view name;
  Dimension dimension;
  double scale;
  double offset = 0.0;
};

constexpr double degree_rad = std::numbers::pi / 180.0;
constexpr double foot_m = 0.3048;
constexpr double nautical_mile_m = 1852.0;
constexpr double pound_kg = 0.45359237;
constexpr double inch_m = 0.0254;
constexpr double atmosphere_pa = 101325.0;

// Those of OpenRocket's preferences (UnitGroup.java) and RocketPy's own; superscripts and the sign of degrees as
// plain() spells them. OpenRocket's knot and inch of mercury differ from these in the sixth digit.
constexpr std::array units{
    Unit{"s", Dimension::time, 1.0},
    Unit{"ms", Dimension::time, 1e-3},
    Unit{"min", Dimension::time, 60.0},
    Unit{"m", Dimension::length, 1.0},
    Unit{"km", Dimension::length, 1e3},
    Unit{"ft", Dimension::length, foot_m},
    Unit{"yd", Dimension::length, 3.0 * foot_m},
    Unit{"mi", Dimension::length, 5280.0 * foot_m},
    Unit{"nmi", Dimension::length, nautical_mile_m},
    Unit{"m/s", Dimension::speed, 1.0},
    Unit{"km/h", Dimension::speed, 1.0 / 3.6},
    Unit{"ft/s", Dimension::speed, foot_m},
    Unit{"mph", Dimension::speed, 5280.0 * foot_m / 3600.0},
    Unit{"kt", Dimension::speed, nautical_mile_m / 3600.0},
    Unit{"m/s2", Dimension::acceleration, 1.0},
    Unit{"ft/s2", Dimension::acceleration, foot_m},
    Unit{"G", Dimension::acceleration, 9.80665},
    Unit{"g", Dimension::acceleration, 9.80665},
    Unit{"deg", Dimension::angle, degree_rad},
    Unit{"rad", Dimension::angle, 1.0},
    Unit{"arcmin", Dimension::angle, degree_rad / 60.0},
    Unit{"kg/m3", Dimension::density, 1.0},
    Unit{"g/cm3", Dimension::density, 1e3},
    Unit{"kg/dm3", Dimension::density, 1e3},
    Unit{"kg/cm3", Dimension::density, 1e6},
    Unit{"lb/ft3", Dimension::density, pound_kg / (foot_m * foot_m * foot_m)},
    Unit{"oz/in3", Dimension::density, pound_kg / 16.0 / (inch_m * inch_m * inch_m)},
    Unit{"K", Dimension::temperature, 1.0},
    Unit{"degC", Dimension::temperature, 1.0, 273.15},
    Unit{"degF", Dimension::temperature, 5.0 / 9.0, 459.67 * 5.0 / 9.0},
    Unit{"Pa", Dimension::pressure, 1.0},
    Unit{"mbar", Dimension::pressure, 1e2},
    Unit{"bar", Dimension::pressure, 1e5},
    Unit{"atm", Dimension::pressure, atmosphere_pa},
    Unit{"mmHg", Dimension::pressure, atmosphere_pa / 760.0},
    Unit{"inHg", Dimension::pressure, 3386.389},
    Unit{"psi", Dimension::pressure, pound_kg * 9.80665 / (inch_m * inch_m)},
};

struct KnownName {
  std::string_view name;
  Quantity quantity;
  Dimension dimension;
  std::string_view writer;
};

// OpenRocket's: FlightDataType. RocketPy's: the second name of each Function of Flight. Of two that hold the same the
// earlier one is taken.
constexpr std::array known_names{
    KnownName{"Time", Quantity::time, Dimension::time, "OpenRocket, RocketPy"},
    KnownName{"Altitude", Quantity::height, Dimension::length, "OpenRocket"},
    KnownName{"Altitude AGL", Quantity::height, Dimension::length, "RocketPy, \"altitude\""},
    KnownName{"Altitude above sea level", Quantity::height_above_sea, Dimension::length, "OpenRocket"},
    KnownName{"Z", Quantity::height_above_sea, Dimension::length, "RocketPy, \"z\""},
    KnownName{"Total velocity", Quantity::speed, Dimension::speed, "OpenRocket"},
    KnownName{"Speed - Velocity Magnitude", Quantity::speed, Dimension::speed, "RocketPy, \"speed\""},
    KnownName{"Vertical velocity", Quantity::up, Dimension::speed, "OpenRocket"},
    KnownName{"Vz", Quantity::up, Dimension::speed, "RocketPy, \"vz\""},
    KnownName{"Lateral velocity", Quantity::across, Dimension::speed, "OpenRocket"},
    KnownName{"Horizontal Speed", Quantity::across, Dimension::speed, "RocketPy, \"horizontal_speed\""},
    KnownName{"Vx", Quantity::east, Dimension::speed, "RocketPy, \"vx\""},
    KnownName{"Vy", Quantity::north, Dimension::speed, "RocketPy, \"vy\""},
    KnownName{"Freestream Speed", Quantity::air_speed, Dimension::speed, "RocketPy, \"free_stream_speed\""},
    KnownName{"Angle of attack", Quantity::angle_of_attack, Dimension::angle, "both"},
    KnownName{"Air density", Quantity::density, Dimension::density, "OpenRocket"},
    KnownName{"Density", Quantity::density, Dimension::density, "RocketPy, \"density\""},
    KnownName{"Air temperature", Quantity::temperature, Dimension::temperature, "OpenRocket"},
    KnownName{"Air pressure", Quantity::pressure, Dimension::pressure, "OpenRocket"},
    KnownName{"Pressure", Quantity::pressure, Dimension::pressure, "RocketPy, \"pressure\""},
    KnownName{"Vertical orientation (zenith)", Quantity::elevation, Dimension::angle, "OpenRocket"},
    KnownName{"Attitude Angle", Quantity::elevation, Dimension::angle, "RocketPy, \"attitude_angle\""},
    KnownName{"Axial Acceleration", Quantity::axial_acceleration, Dimension::acceleration,
              "RocketPy, \"axial_acceleration\""},
};

/// What a rocket can have, in SI: beyond it a column is not what its name says.
struct Range {
  double least;
  double most;
};

Range range_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::time: return {-1e5, 1e5};
    case Dimension::length: return {-1e4, 1e6};
    case Dimension::speed: return {-2e4, 2e4};
    case Dimension::acceleration: return {-1e5, 1e5};
    case Dimension::angle: return {-7.0, 7.0};
    case Dimension::density: return {1e-4, 5.0};
    case Dimension::temperature: return {100.0, 400.0};
    case Dimension::pressure: break;
  }
  return {1.0, 3e5};
}

struct Header {
  std::string_view name;
  std::string_view unit;  ///< empty: none
};

Header split(std::string_view column) {
  const std::string_view all = text::trimmed(column);
  const std::size_t open = all.rfind('(');
  if (!all.ends_with(')') || open == std::string_view::npos || open == 0) {
    return {all, {}};
  }
  return {text::trimmed(all.substr(0, open)), text::trimmed(all.substr(open + 1, all.size() - open - 2))};
}

/// Superscripts as digits, the sign of degrees as a word, in UTF-8 or Latin-1.
std::string plain(std::string_view unit) {
  std::string result;
  for (const char c : unit) {
    switch (static_cast<unsigned char>(c)) {
      case 0xC2:
      case '^': break;
      case 0xB0: result += "deg"; break;
      case 0xB2: result += '2'; break;
      case 0xB3: result += '3'; break;
      default: result += c;
    }
  }
  return result;
}

bool same_but_for_capitals(std::string_view a, std::string_view b) {
  const auto lower = [](unsigned char c) { return std::tolower(c); };
  return std::ranges::equal(a, b, {}, lower, lower);
}

const Unit* find_unit(const std::string& name, Dimension dimension) {
  const auto* found =
      std::ranges::find_if(units, [&](const Unit& unit) { return unit.name == name && unit.dimension == dimension; });
  return found == units.end() ? nullptr : found;
}

std::string unit_names(Dimension dimension) {
  std::string names;
  for (const Unit& unit : units) {
    if (unit.dimension == dimension) {
      names += (names.empty() ? "" : ", ") + std::string{unit.name};
    }
  }
  return names;
}

}  // namespace

Columns::Columns(const flight::Table& table) {
  for (const KnownName& known : known_names) {
    for (std::size_t i = 0; i < table.columns().size() && !has(known.quantity); ++i) {
      const Header header = split(table.columns()[i]);
      // A name of OpenRocket has parentheses of its own.
      const bool no_unit = same_but_for_capitals(text::trimmed(table.columns()[i]), known.name);
      if (!no_unit && !same_but_for_capitals(header.name, known.name)) {
        continue;
      }
      const Unit* unit = no_unit ? nullptr : find_unit(plain(header.unit), known.dimension);
      if (unit == nullptr) {
        throw text::Error{text::ErrorKind::bad_data,
                          fmt::format("{}:{}: the column {} {}; allowed, in parentheses behind the name: {}",
                                      table.name(), table.header_line(), flight::in_quotes(table.columns()[i]),
                                      no_unit || header.unit.empty() ? "has no unit" : "has a unit that is not known",
                                      unit_names(known.dimension))};
      }
      const Range range = range_of(known.dimension);
      found_.push_back(
          {known.quantity, i, std::string{known.name}, unit->scale, unit->offset, range.least, range.most});
    }
  }
}

const FoundColumn* Columns::find(Quantity quantity) const {
  const auto found = std::ranges::find(found_, quantity, &FoundColumn::quantity);
  return found == found_.end() ? nullptr : &*found;
}

std::string_view word(Quantity quantity) {
  switch (quantity) {
    case Quantity::time: return "time";
    case Quantity::height: return "height";
    case Quantity::height_above_sea: return "height above the sea";
    case Quantity::speed: return "total speed";
    case Quantity::up: return "vertical speed";
    case Quantity::across: return "horizontal speed";
    case Quantity::east: return "speed to the east";
    case Quantity::north: return "speed to the north";
    case Quantity::air_speed: return "air speed";
    case Quantity::angle_of_attack: return "angle of attack";
    case Quantity::density: return "air density";
    case Quantity::temperature: return "temperature";
    case Quantity::pressure: return "pressure";
    case Quantity::elevation: return "tilt";
    case Quantity::axial_acceleration: return "acceleration along the axis";
  }
  return "";
}

std::string names_of(Quantity quantity) {
  std::string names;
  for (const KnownName& known : known_names) {
    if (known.quantity == quantity) {
      names += fmt::format("{}\"{}\" ({})", names.empty() ? "" : " or ", known.name, known.writer);
    }
  }
  return names;
}

}  // namespace fantail::trajectory
