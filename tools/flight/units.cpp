// SPDX-License-Identifier: MIT
#include "flight/units.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace fantail::flight {
namespace {

constexpr double turn_rad = 2.0 * std::numbers::pi;
constexpr double degree_rad = std::numbers::pi / 180.0;  // to the bit as text::radians()
constexpr double foot_m = 0.3048;

constexpr std::array all{
    Unit{"s", Dimension::time, 1.0},
    Unit{"ms", Dimension::time, 1e-3},
    Unit{"us", Dimension::time, 1e-6},
    Unit{"deg", Dimension::angle, degree_rad},
    Unit{"rad", Dimension::angle, 1.0},
    Unit{"mrad", Dimension::angle, 1e-3},
    Unit{"turn", Dimension::angle, turn_rad},
    Unit{"deg/s", Dimension::angular_rate, degree_rad},
    Unit{"rad/s", Dimension::angular_rate, 1.0},
    Unit{"mdeg/s", Dimension::angular_rate, 1e-3 * degree_rad},
    Unit{"rpm", Dimension::angular_rate, turn_rad / 60.0},
    Unit{"turn/s", Dimension::angular_rate, turn_rad},
    Unit{"m", Dimension::length, 1.0},
    Unit{"km", Dimension::length, 1e3},
    Unit{"ft", Dimension::length, foot_m},
    Unit{"m/s", Dimension::speed, 1.0},
    Unit{"km/h", Dimension::speed, 1.0 / 3.6},
    Unit{"ft/s", Dimension::speed, foot_m},
    Unit{"m/s2", Dimension::acceleration, 1.0},
    Unit{"g", Dimension::acceleration, 9.80665},
    Unit{"ft/s2", Dimension::acceleration, foot_m},
};

struct Suffix {
  std::string_view text;
  Dimension dimension;
};
// A longer one before one that it ends in.
constexpr std::array suffixes{Suffix{"_deg_s", Dimension::angular_rate}, Suffix{"_m_s2", Dimension::acceleration},
                              Suffix{"_m_s", Dimension::speed},          Suffix{"_deg", Dimension::angle},
                              Suffix{"_m", Dimension::length},           Suffix{"_s", Dimension::time}};

}  // namespace

std::span<const Unit> units() { return all; }

const Unit* find_unit(std::string_view name) {
  const auto found = std::ranges::find(all, name, &Unit::name);
  return found == all.end() ? nullptr : &*found;
}

std::string unit_names(Dimension dimension) {
  std::string names;
  for (const Unit& unit : all) {
    if (unit.dimension == dimension) {
      names += (names.empty() ? "" : ", ") + std::string{unit.name};
    }
  }
  return names;
}

Quantity quantity_of(std::string_view column) {
  for (const Suffix& suffix : suffixes) {
    if (column.ends_with(suffix.text)) {
      return {column.substr(0, column.size() - suffix.text.size()), suffix.dimension};
    }
  }
  return {column, {}};
}

}  // namespace fantail::flight
