// SPDX-License-Identifier: MIT
#include "airframe/openrocket/stored_flight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include "airframe/openrocket/stored_columns.hpp"
#include "text/number.hpp"

namespace fantail::airframe::openrocket {
namespace {

constexpr double slow_mach = 0.5;
constexpr double small_angle_rad = 5.0 * std::numbers::pi / 180.0;
constexpr double falling_m_s = -1.0;

using Row = std::array<std::optional<double>, quantities>;

std::vector<std::string_view> cells(std::string_view line) {
  std::vector<std::string_view> found;
  for (;;) {
    const std::size_t comma = line.find(',');
    found.push_back(text::trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) {
      return found;
    }
    line.remove_prefix(comma + 1);
  }
}

std::array<std::optional<std::size_t>, quantities> columns_of(std::string_view types) {
  std::array<std::optional<std::size_t>, quantities> places{};
  const std::vector<std::string_view> names = cells(types);
  for (std::size_t q = 0; q < quantities; ++q) {
    const auto found = std::ranges::find_if(names, [&](std::string_view name) {
      const auto known = stored_columns()[q];
      return std::ranges::find(known, name) != known.end();
    });
    if (found != names.end()) {
      places[q] = static_cast<std::size_t>(found - names.begin());
    }
  }
  return places;
}

/// A flight whose centre of pressure is that at the smallest angle of attack of its slow ascent.
StoredFlight flight_of(pugi::xml_node branch) {
  StoredFlight flight;
  const auto columns = columns_of(branch.attribute("types").as_string());
  double least_rad = std::numeric_limits<double>::infinity();
  for (const pugi::xml_node point : branch.children("datapoint")) {
    const std::vector<std::string_view> words = cells(point.text().as_string());
    Row row{};
    for (std::size_t q = 0; q < quantities; ++q) {
      row[q] = columns[q] && *columns[q] < words.size() ? text::number(words[*columns[q]]) : std::nullopt;
    }
    if (row[climb].value_or(0.0) < falling_m_s) {
      break;
    }
    flight.mass_kg = flight.mass_kg ? flight.mass_kg : row[mass];
    flight.centre_of_gravity_m = flight.centre_of_gravity_m ? flight.centre_of_gravity_m : row[gravity];
    if (row[pressure].value_or(1.0) == 0.0) {  // without an angle of attack there is no force, and so no place of it
      row[pressure] = row[margin] = std::nullopt;
    }
    const double angle_rad = std::abs(row[angle].value_or(0.0));
    if ((row[pressure] || row[margin]) && row[mach].value_or(0.0) <= slow_mach && angle_rad <= small_angle_rad &&
        angle_rad < least_rad) {
      least_rad = angle_rad;
      flight.centre_of_pressure_m = row[pressure];
      flight.margin_calibres = row[margin];
      flight.angle_of_attack_rad = angle_rad;
    }
  }
  return flight;
}

/// What of it no rocket has, as the end of a sentence; empty: nothing.
std::string impossible(const StoredFlight& flight) {
  for (const auto& [name, value, most] :
       {std::tuple{"mass", flight.mass_kg, 1'000.0}, std::tuple{"centre of gravity", flight.centre_of_gravity_m, 30.0},
        std::tuple{"centre of pressure", flight.centre_of_pressure_m, 30.0}}) {
    if (value && !(*value >= 0.001 && *value <= most)) {
      return fmt::format("its {} is {}", name, *value);
    }
  }
  return {};
}

bool belongs_to_design(pugi::xml_node simulation) {
  const std::string_view status = simulation.attribute("status").as_string();
  return status == "uptodate" || status == "loaded" || status == "external";
}

}  // namespace

std::vector<StoredFlight> stored_flights(pugi::xml_node simulations, std::vector<std::string>& not_used) {
  std::vector<StoredFlight> flights;
  for (const pugi::xml_node simulation : simulations.children("simulation")) {
    const pugi::xml_node branch = simulation.child("flightdata").child("databranch");
    if (!belongs_to_design(simulation) || !branch) {
      continue;
    }
    StoredFlight flight = flight_of(branch);
    flight.name = simulation.child("name").text().as_string();
    flight.configuration = simulation.child("conditions").child("configid").text().as_string();
    if (const std::string why = impossible(flight); !why.empty()) {
      not_used.push_back(fmt::format("Simulation \"{}\": its stored flight, because {}.", flight.name, why));
      continue;
    }
    if (flight.mass_kg || flight.centre_of_gravity_m || flight.centre_of_pressure_m || flight.margin_calibres) {
      flights.push_back(std::move(flight));
    }
  }
  return flights;
}

}  // namespace fantail::airframe::openrocket
