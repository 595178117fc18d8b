// SPDX-License-Identifier: MIT
#include "fantail/airframe_options.hpp"

#include "fantail/command_line.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"

namespace fantail::tool {

void add_airframe_options(const Verb& verb, AirframeOptions& options) {
  verb.option("--vehicle", options.vehicle, "Vehicle with the inertia and reference area: a shipped name or a path")
      .value_name("FILE")
      .show_default();
  verb.option("--inertia", options.inertia_kg_m2, "Roll inertia, instead of the vehicle's")
      .check(within(1e-9, 1e6))
      .value_name("KG_M2");
  verb.option("--area", options.area_m2, "Reference area, instead of the vehicle's")
      .check(within(1e-9, 1e6))
      .value_name("M2");
}

NamedAirframe airframe(const AirframeOptions& options) {
  if (options.inertia_kg_m2 && options.area_m2) {
    return {"from the command line", {.inertia_kg_m2 = *options.inertia_kg_m2, .reference_area_m2 = *options.area_m2}};
  }
  const sim::Vehicle vehicle =
      input::read_vehicle(input::Document::load(input::find_input(input::Shipped::vehicle, options.vehicle)));
  return {vehicle.name,
          {.inertia_kg_m2 = options.inertia_kg_m2.value_or(vehicle.roll_plant.inertia_kg_m2),
           .reference_area_m2 = options.area_m2.value_or(vehicle.roll_plant.reference_area_m2)}};
}

}  // namespace fantail::tool
