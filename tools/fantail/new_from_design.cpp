// SPDX-License-Identifier: MIT
#include "fantail/new_from_design.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "airframe/openrocket/solids.hpp"
#include "input/messages.hpp"
#include "input/vehicle_file.hpp"
#include "text/error.hpp"

namespace fantail::tool {
namespace {

namespace openrocket = airframe::openrocket;

/// A comment ends with its line, and a sentence in a vehicle has no other letters either.
std::string on_one_line(std::string text) {
  std::ranges::replace_if(text, [](unsigned char c) { return c < 0x20; }, ' ');
  return text;
}

struct Case {
  double length_m = 0.0;
  double diameter_m = 0.0;
};

/// As long as the design has this motor, else as its own file has it.
Case case_of(const openrocket::MotorPlace& place, const input::RaspMotor& motor, std::vector<std::string>& assumed) {
  const std::vector<openrocket::NamedMotor> same = place.called(motor.name);
  if (!same.empty() && same.front().length_m > 0.0) {
    return {same.front().length_m, same.front().diameter_m};
  }
  if (motor.length_m > 0.0) {
    assumed.push_back(fmt::format("Motor: the design does not give the length of {}; its own file says {} mm.",
                                  on_one_line(motor.name), input::plain_number(1000.0 * motor.length_m)));
    return {motor.length_m, motor.diameter_m};
  }
  const auto longest = std::ranges::max_element(place.motors, {}, &openrocket::NamedMotor::length_m);
  assumed.push_back(fmt::format("Motor: no file gives the length of {}; the longest of the design is taken, {} mm.",
                                on_one_line(motor.name), input::plain_number(1000.0 * longest->length_m)));
  return {longest->length_m, longest->diameter_m};
}

void add_motor(sim::Geometry& shape, const openrocket::MotorPlace& place, const input::RaspMotor& motor,
               std::vector<std::string>& assumed) {
  const Case size = case_of(place, motor, assumed);
  sim::Geometry::Mass part{.name = place.count > 1 ? "motor cases" : "motor case",
                           .mass_kg = place.count * (motor.total_kg - motor.curve.propellant_kg()),
                           .position_m = place.end_m - 0.5 * size.length_m,
                           .length_m = size.length_m,
                           .radius_of_gyration_m = std::hypot(0.35 * size.diameter_m, place.ring_m)};
  openrocket::shorten_to_rocket(part, shape.length_m + shape.diameter_m);
  shape.masses.push_back(part);
  shape.propellant = part;
  assumed.emplace_back("Propellant: taken to be as long as the motor case.");
}

/// What the design's file says of a flight with this motor, and what of it was left out.
sim::Geometry::Design stored(const openrocket::Design& design, const std::string& file, const input::RaspMotor& motor) {
  sim::Geometry::Design result{.file = on_one_line(file)};
  for (const openrocket::LeftOut& one : design.left_out) {
    result.left_out.push_back(on_one_line(one.what));
  }
  const std::vector<openrocket::NamedMotor> same =
      design.motor ? design.motor->called(motor.name) : std::vector<openrocket::NamedMotor>{};
  const auto flown = std::ranges::find_if(design.flights, [&](const openrocket::StoredFlight& flight) {
    return std::ranges::find(same, flight.configuration, &openrocket::NamedMotor::configuration) != same.end();
  });
  if (flown == design.flights.end()) {
    return result;
  }
  result.flight = on_one_line(flown->name);
  result.mass_kg = flown->mass_kg;
  result.centre_of_gravity_m = flown->centre_of_gravity_m;
  result.centre_of_pressure_m = flown->centre_of_pressure_m;
  result.angle_of_attack_rad = flown->angle_of_attack_rad;
  result.margin_calibres = flown->margin_calibres;
  return result;
}

}  // namespace

bool is_openrocket(const std::string& file) {
  std::string end = std::filesystem::path{file}.extension().string();
  std::ranges::transform(end, end.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [other, program] : {std::pair{".rkt", "RockSim"}, std::pair{".cdx1", "RASAero"}}) {
    if (end == other) {
      throw text::Error{text::ErrorKind::bad_data,
                        fmt::format("{}: a design of {}, which is not read; open it in OpenRocket and save it as .ork",
                                    file, program)};
    }
  }
  return end == ".ork";
}

airframe::NewRocket rocket_of_design(const openrocket::Design& design, const std::string& file,
                                     const input::RaspMotor& motor) {
  constexpr double drag_coefficient = 0.6;
  airframe::NewRocket rocket{.name = {},
                             .vehicle = {},
                             .motor_file = {},
                             .source = on_one_line(file + (design.name.empty() ? "" : ", \"" + design.name + '"')),
                             .assumed = design.assumed};
  sim::Vehicle& vehicle = rocket.vehicle;
  vehicle.motor_count = design.motor ? design.motor->count : 1;
  vehicle.motor = input::motors(motor.curve, vehicle.motor_count, 1.0);
  vehicle.geometry = design.geometry;
  sim::Geometry& shape = *vehicle.geometry;
  if (vehicle.motor_count > 1) {
    rocket.assumed.push_back(fmt::format("Motors: {} of {}, as the design has them in its cluster, all lit at once.",
                                         vehicle.motor_count, on_one_line(motor.name)));
  }
  if (design.motor) {
    add_motor(shape, *design.motor, motor, rocket.assumed);
  } else {
    rocket.assumed.emplace_back("Motor: the design does not give its position, so balance and inertia are unknown.");
  }
  shape.design = stored(design, file, motor);
  vehicle.mass_kg = vehicle.motor.propellant_kg();
  for (const sim::Geometry::Mass& mass : shape.masses) {
    vehicle.mass_kg += mass.mass_kg;
  }
  vehicle.roll_plant.inertia_kg_m2 = 0.5 * vehicle.mass_kg * 0.25 * shape.diameter_m * shape.diameter_m;
  vehicle.drag_area_m2 = drag_coefficient * 0.25 * std::numbers::pi * shape.diameter_m * shape.diameter_m;
  rocket.assumed.push_back(fmt::format("Drag: a coefficient of {} on the cross-section.", drag_coefficient));
  return rocket;
}

}  // namespace fantail::tool
