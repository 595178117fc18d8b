// SPDX-License-Identifier: MIT
#include "fantail/airframe_options.hpp"

#include <cmath>

#include <fmt/core.h>

#include "fantail/offers.hpp"
#include "input/document.hpp"
#include "input/messages.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "logs/flight_file.hpp"

namespace fantail::tool {
namespace {

using identify::model::Airframe;
using input::about;

Airframe airframe_of(const flight::FlownAirframe& flown) {
  return {.inertia_kg_m2 = flown.roll_inertia_kg_m2, .reference_area_m2 = flown.reference_area_m2};
}

[[noreturn]] void refuse_unknown() {
  std::string message =
      "no rocket given, and no summary.json beside the log says which one flew: use --vehicle NAME|FILE, or --inertia "
      "and --area; shipped vehicles:";
  for (const std::string& name : input::shipped_names(input::Shipped::vehicle)) {
    message += " " + name;
  }
  throw UsageError{message};
}

bool differ(double a, double b) { return std::abs(a - b) > 1e-6 * std::abs(b); }

std::string inertia_of(const flight::FlownAirframe& flown) {
  const auto& course = flown.roll_inertia_course;
  return about(flown.roll_inertia_kg_m2) + " kg m2" +
         (course.empty() ? "" : fmt::format(" at lift-off, {} after burn-out,", about(course.rbegin()->second)));
}

/// What was simulated is used, unless something else was asked for: then that is said.
void compare_with_flown(NamedAirframe& result, const flight::FlownAirframe& flown, bool inertia_was_given) {
  const auto& [inertia_kg_m2, area_m2] = result.airframe;
  result.grows_with_mach = flown.grows_with_mach;
  const bool same_inertia =
      !differ(inertia_kg_m2, flown.roll_inertia_kg_m2) && (!inertia_was_given || flown.roll_inertia_course.empty());
  if (same_inertia) {
    result.flown_inertia = flown.roll_inertia_course;
    result.inertia_since_ignition.clear();
  }
  if (!same_inertia || differ(area_m2, flown.reference_area_m2)) {
    result.warnings.push_back(fmt::format(
        "the flight was simulated with the vehicle {}, I {} and A {} m2; as asked for, I {} and A {} are used instead",
        flown.vehicle_file, inertia_of(flown), about(flown.reference_area_m2), about(inertia_kg_m2), about(area_m2)));
  }
}

}  // namespace

void add_airframe_options(const Verb& verb, AirframeOptions& options) {
  verb.option(
          "--vehicle", options.vehicle,
          "Vehicle with inertia and reference area: a shipped name or a path [the one in the flight's summary.json]")
      .offers(shipped(input::Shipped::vehicle))
      .value_name("NAME|FILE");
  verb.option("--inertia", options.inertia_kg_m2, "Roll moment of inertia, instead of the vehicle's")
      .check(within(1e-9, 1e6))
      .value_name("KG_M2");
  verb.option("--area", options.area_m2, "Reference area, instead of the vehicle's")
      .check(within(1e-9, 1e6))
      .value_name("M2");
}

NamedAirframe named_airframe(const AirframeOptions& options, const std::filesystem::path& log,
                             const logs::Reading& reading) {
  const std::optional<flight::FlownAirframe> flown = logs::flown_airframe(log, reading);
  NamedAirframe result;
  if (options.vehicle) {
    const sim::Vehicle vehicle =
        input::read_vehicle(input::Document::load(input::find_input(input::Shipped::vehicle, *options.vehicle)));
    result.airframe = {vehicle.roll_plant.inertia_kg_m2, vehicle.roll_plant.reference_area_m2};
    result.name = result.vehicle = vehicle.name;
    if (vehicle.compressibility != sim::Compressibility::none) {
      result.grows_with_mach = true;
    }
    if (!options.inertia_kg_m2) {
      result.inertia_since_ignition = sim::roll_inertia_course(vehicle);
    }
  } else if (options.inertia_kg_m2 && options.area_m2) {
    result.name = "from the command line";
  } else if (flown) {
    result.airframe = airframe_of(*flown);
    result.vehicle = flown->vehicle;
    const bool is_file = flown->vehicle_file.ends_with(".toml") && !flown->vehicle.empty();
    result.name = (is_file ? flown->vehicle : flown->vehicle_file) + " (summary.json)";
  } else if (!std::filesystem::exists(log)) {
    throw text::Error{text::ErrorKind::no_such_input, log.string() + ": no such file"};
  } else {
    refuse_unknown();
  }
  result.airframe.inertia_kg_m2 = options.inertia_kg_m2.value_or(result.airframe.inertia_kg_m2);
  result.airframe.reference_area_m2 = options.area_m2.value_or(result.airframe.reference_area_m2);
  if (flown) {
    compare_with_flown(result, *flown, options.inertia_kg_m2.has_value());
  }
  return result;
}

}  // namespace fantail::tool
