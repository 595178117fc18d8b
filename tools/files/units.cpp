// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <numbers>

#include "files/quantities.hpp"

namespace fantail::files {
namespace {

constexpr double turn_rad = 2.0 * std::numbers::pi;
constexpr double degree_rad = std::numbers::pi / 180.0;  // to the bit as text::radians()
constexpr double foot_m = 0.3048;
constexpr double nautical_mile_m = 1852.0;
constexpr double g_m_s2 = 9.80665;
constexpr double pound_kg = 0.45359237;
constexpr double inch_m = 0.0254;
constexpr double atmosphere_pa = 101325.0;

// The first of a dimension is that of Fantail's own files. Those of OpenRocket's preferences (UnitGroup.java) and of
// RocketPy are among them; OpenRocket's knot and inch of mercury differ from these in the sixth digit.
constexpr std::array all_units{
    Unit{"s", Dimension::time, 1.0},
    Unit{"ms", Dimension::time, 1e-3},
    Unit{"us", Dimension::time, 1e-6},
    Unit{"ns", Dimension::time, 1e-9},
    Unit{"min", Dimension::time, 60.0},
    Unit{"h", Dimension::time, 3600.0},
    Unit{"deg", Dimension::angle, degree_rad},
    Unit{"rad", Dimension::angle, 1.0},
    Unit{"mrad", Dimension::angle, 1e-3},
    Unit{"turn", Dimension::angle, turn_rad},
    Unit{"arcmin", Dimension::angle, degree_rad / 60.0},
    Unit{"deg/s", Dimension::angular_rate, degree_rad},
    Unit{"rad/s", Dimension::angular_rate, 1.0},
    Unit{"mdeg/s", Dimension::angular_rate, 1e-3 * degree_rad},
    Unit{"rpm", Dimension::angular_rate, turn_rad / 60.0},
    Unit{"turn/s", Dimension::angular_rate, turn_rad},
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
    Unit{"g", Dimension::acceleration, g_m_s2},
    Unit{"ft/s2", Dimension::acceleration, foot_m},
    Unit{"G", Dimension::acceleration, g_m_s2},
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
    Unit{"psi", Dimension::pressure, pound_kg* g_m_s2 / (inch_m * inch_m)},
};

}  // namespace

const Unit* find_unit(std::string_view name) {
  const auto found = std::ranges::find(all_units, name, &Unit::name);
  return found == all_units.end() ? nullptr : &*found;
}

const Unit& own_unit(Dimension dimension) { return *std::ranges::find(all_units, dimension, &Unit::dimension); }

std::string unit_names(Dimension dimension) {
  std::string names;
  for (const Unit& unit : all_units) {
    if (unit.dimension == dimension) {
      names += (names.empty() ? "" : ", ") + std::string{unit.name};
    }
  }
  return names;
}

std::string plainly_spelt(std::string_view unit) {
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
  constexpr std::string_view second = "sec";
  if (const std::size_t at = result.find(second); at != std::string::npos) {
    result.replace(at, second.size(), "s");
  }
  return result;
}

}  // namespace fantail::files
