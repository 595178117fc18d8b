// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include <fmt/core.h>

#include "predict/airframe.hpp"
#include "text/error.hpp"

namespace fantail::predict {

namespace {

/// Written with six digits.
bool same_inertia(double one, double other) {
  constexpr double rounding = 1e-4;
  return std::abs(one / other - 1.0) < rounding;
}

}  // namespace

void require_same_vehicle(const sim::Scenario& scenario, const TunnelResult& tunnel) {
  if (tunnel.vehicle && *tunnel.vehicle != scenario.vehicle.name) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      fmt::format("{}: its rows are of the vehicle \"{}\", and {} flies \"{}\"; allowed: rows of that "
                                  "vehicle, or --other-vehicle to accept these",
                                  tunnel.name, *tunnel.vehicle, scenario.name, scenario.vehicle.name)};
  }
}

std::string whose_rows(const sim::Scenario& scenario, const TunnelResult& tunnel) {
  const double own_kg_m2 = scenario.vehicle.roll_plant.inertia_kg_m2;
  const std::string inertia =
      !tunnel.inertia_kg_m2 ? "the roll inertia that they were identified with is not stated"
      : same_inertia(*tunnel.inertia_kg_m2, own_kg_m2)
          ? "they were identified with its roll inertia"
          : fmt::format(
                "they were identified with a roll inertia of {:.4g} kg m2, where this vehicle has {:.4g}. Damping and "
                "torque are right only if the rocket in the tunnel had the former",
                *tunnel.inertia_kg_m2, own_kg_m2);
  if (!tunnel.vehicle) {
    return fmt::format("{} does not name the vehicle of its rows; they are used for {}{}.", tunnel.name,
                       scenario.vehicle.name, tunnel.inertia_kg_m2 ? "; " + inertia : "");
  }
  return *tunnel.vehicle == scenario.vehicle.name
             ? fmt::format("The rows of {} name this vehicle, {}; {}.", tunnel.name, *tunnel.vehicle, inertia)
             : fmt::format("The rows of {} are of another vehicle, {}, and were accepted for {} on purpose.",
                           tunnel.name, *tunnel.vehicle, scenario.vehicle.name);
}

std::string which_area(const sim::Scenario& scenario, const TunnelResult& tunnel) {
  const double area_m2 = scenario.vehicle.roll_plant.reference_area_m2;
  if (tunnel.reference_area_m2) {
    return *tunnel.reference_area_m2 == area_m2
               ? fmt::format("The rows of {} were identified with the reference area of this vehicle, {:.4g} m2.",
                             tunnel.name, area_m2)
               : fmt::format(
                     "Damping and torque of {} were identified with a reference area of {:.4g} m2 and are "
                     "converted to that of this vehicle, {:.4g} m2.",
                     tunnel.name, *tunnel.reference_area_m2, area_m2);
  }
  const std::vector<double>& range = scenario.vehicle.reference_area_range_m2;
  const std::string unknown = fmt::format(
      "{} does not state the reference area that its rows were identified with; that of this vehicle is used, {:.4g} "
      "m2",
      tunnel.name, area_m2);
  return range.empty()
             ? unknown + ", as if it were exact."
             : fmt::format(
                   "{}. By the vehicle file it lies with 95 % probability between {:.2g} and {:.2g} m2. Damping and "
                   "torque of each run are multiplied by a factor drawn from that range's distribution.",
                   unknown, range[0], range[1]);
}

std::optional<std::string> wash_in_rows(const sim::Scenario& scenario, const TunnelResult& tunnel) {
  const double wash = scenario.vehicle.canard_air.wash;
  return wash > 0.0 ? std::optional{fmt::format(
                          "The torque in the rows of {} is used as that of the canards alone, and the fins take back "
                          "{:g} times that torque (aerodynamics.canard_wash). If the rows were identified with the "
                          "fins on, they include this already, and it is counted twice.",
                          tunnel.name, wash)}
                    : std::nullopt;
}

std::optional<AreaFactor> area_factor(const sim::Scenario& scenario, const TunnelResult& tunnel) {
  const std::vector<double>& range = scenario.vehicle.reference_area_range_m2;
  const double area_m2 = scenario.vehicle.roll_plant.reference_area_m2;
  return tunnel.reference_area_m2 || range.empty()
             ? std::nullopt
             : std::optional{AreaFactor{.low = range[0] / area_m2, .high = range[1] / area_m2}};
}

TunnelResult for_vehicle(const sim::Scenario& scenario, TunnelResult tunnel) {
  const double area_m2 = scenario.vehicle.roll_plant.reference_area_m2;
  const double factor = tunnel.reference_area_m2.value_or(area_m2) / area_m2;
  for (TunnelStep& step : tunnel.steps) {
    step.damping_m2 *= factor;
    step.torque_m *= factor;
  }
  for (TunnelStep& error : tunnel.standard_errors) {
    error.damping_m2 *= factor;
    error.torque_m *= factor;
  }
  return tunnel;
}

}  // namespace fantail::predict
