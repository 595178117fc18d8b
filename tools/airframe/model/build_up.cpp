// SPDX-License-Identifier: MIT
#include "airframe/model/build_up.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "airframe/model/body.hpp"

namespace fantail::airframe::model {
namespace {

constexpr double slope_error = 0.10;
constexpr double position_error = 0.03;
constexpr double roll_factor = 2.0;
/// Of body lift on the side area, at large angles (Galejs, Wind instability: 1.0 to 1.5).
constexpr double body_lift_coefficient = 1.1;
/// Where the lift of a small plate acts, in shares of its chord: thin theory, and how far low aspect ratios are from
/// it.
constexpr Estimate lift_along_chord{.value = 0.25, .low = 0.15, .high = 0.35};

Estimate within_share(double value, double share) {
  return {.value = value, .low = value * (1.0 - share), .high = value * (1.0 + share)};
}

Estimate within_factor(double value, double factor) {
  return {.value = value, .low = value / factor, .high = value * factor};
}

void sum_parts(BuildUp& result) {
  double slope = 0.0;
  double moment_m = 0.0;
  for (const Part& part : result.parts) {
    slope += part.slope_per_rad;
    moment_m += part.slope_per_rad * part.position_m;
  }
  const double centre_m = moment_m / slope;
  double spread_m2 = 0.0;
  for (const Part& part : result.parts) {
    const double away_m = part.position_m - centre_m;
    spread_m2 += part.slope_per_rad * away_m * away_m / slope;
  }
  result.normal_force_slope_per_rad = within_share(slope, slope_error);
  result.centre_of_pressure_m = within_share(centre_m, position_error);
  result.parts_spread_m = std::sqrt(std::max(0.0, spread_m2));
}

/// Of a set over its mean, in a plane at this angle: a fin that lies in the plane of the flow's angle feels nothing of
/// it. Three or more, evenly around, are the same in all planes.
double share_in_plane(const sim::Geometry::MoreFins& more, double plane_rad) {
  if (more.set.count >= 3) {
    return 1.0;
  }
  const double across = std::sin(plane_rad - more.first_angle_rad);
  return 2.0 * across * across;  // two lie opposite to each other
}

void find_worst_plane(BuildUp& result, const sim::Geometry& shape) {
  const auto is_alike = [](const sim::Geometry::MoreFins& more) { return more.set.count >= 3; };
  if (std::ranges::all_of(shape.more_fins, is_alike)) {
    return;
  }
  constexpr int planes = 360;  // of half a turn
  double worst_m = std::numeric_limits<double>::infinity();
  const std::size_t first = result.parts.size() - shape.more_fins.size();
  for (int i = 0; i < planes; ++i) {
    double slope = 0.0;
    double moment_m = 0.0;
    for (std::size_t part = 0; part < result.parts.size(); ++part) {
      const double share =
          part < first ? 1.0 : share_in_plane(shape.more_fins[part - first], std::numbers::pi * i / planes);
      slope += share * result.parts[part].slope_per_rad;
      moment_m += share * result.parts[part].slope_per_rad * result.parts[part].position_m;
    }
    worst_m = std::min(worst_m, moment_m / slope);
  }
  result.worst_centre_of_pressure_m = within_share(worst_m, position_error);
}

void add_canards(BuildUp& result, const sim::Geometry& shape, const FinForces& canards,
                 const std::optional<FinForces>& fins) {
  result.roll_torque_m3 = within_factor(canards.roll_torque_m3, roll_factor);
  result.canard_arm_m = canards.arm_m;
  if (fins && shape.fins->position_m > shape.canards->position_m) {
    result.roll_torque_m3->low = 0.0;
  }
  if (fins) {
    // Both torques are right within the factor, the fins' as their damping.
    result.cant_as_canards = within_factor(fins->roll_torque_m3 / canards.roll_torque_m3, roll_factor * roll_factor);
    if (result.roll_torque_m3->low == 0.0) {  // no angle of canards without torque pushes as the fins do
      result.cant_as_canards->high = std::numeric_limits<double>::infinity();
    }
  }
  if (shape.canard_hinge_m) {
    const auto moment_m3 = [&](double along) {
      const double lift_m = canards.mean_chord_front_m + along * canards.mean_chord_m;
      return canards.one_fin_area_m2 * (lift_m - *shape.canard_hinge_m);
    };
    result.hinge_moment_m3 = Estimate{.value = moment_m3(lift_along_chord.value),
                                      .low = moment_m3(lift_along_chord.low),
                                      .high = moment_m3(lift_along_chord.high)};
  }
}

void add_masses(BuildUp& result, const sim::Vehicle& vehicle) {
  const sim::Geometry& shape = *vehicle.geometry;
  const auto heavy = [](const sim::Geometry::Mass& part) { return part.mass_kg > 0.0; };
  if (!std::ranges::any_of(shape.masses, heavy)) {
    return;
  }
  result.after_burnout = sum_of(shape.masses);
  if (shape.propellant) {
    std::vector<sim::Geometry::Mass> all = shape.masses;
    all.push_back(*shape.propellant);
    all.back().mass_kg = vehicle.motor.propellant_kg();
    result.at_liftoff = sum_of(all);
  }
}

}  // namespace

BuildUp build_up(const sim::Vehicle& vehicle) {
  const sim::Geometry& shape = *vehicle.geometry;
  const double cross_section_m2 = 0.25 * std::numbers::pi * shape.diameter_m * shape.diameter_m;
  const BodyForces body = body_forces(shape);
  BuildUp result;
  result.parts.push_back({"nose", body.nose_slope_area_m2 / cross_section_m2, body.nose_position_m});
  for (std::size_t i = 0; i < body.transitions.size(); ++i) {
    const auto& [slope_area_m2, position_m] = body.transitions[i];
    const std::string number = body.transitions.size() > 1 ? " " + std::to_string(i + 1) : "";
    result.parts.push_back({"transition" + number, slope_area_m2 / cross_section_m2, position_m});
  }
  double damping_m4 = 0.0;
  const auto add = [&](const std::string& name,
                       const std::optional<sim::Geometry::FinSet>& set) -> std::optional<FinForces> {
    if (!set) {
      return {};
    }
    const FinForces forces = fin_forces(*set, radius_m(shape, set->position_m + 0.5 * set->root_chord_m));
    result.parts.push_back({name, forces.slope_area_m2 / cross_section_m2, forces.position_m});
    damping_m4 += forces.roll_damping_m4;
    result.canted_torque_m3 += set->cant_rad * forces.roll_torque_m3;
    return forces;
  };
  const std::optional<FinForces> canards = add("canards", shape.canards);
  const std::optional<FinForces> fins = add("fins", shape.fins);
  for (const sim::Geometry::MoreFins& more : shape.more_fins) {
    (void)add(more.name, more.set);
  }
  sum_parts(result);
  find_worst_plane(result, shape);
  result.body_lift_area_m2 = body_lift_coefficient * body.side_area_m2;
  result.body_lift_position_m = body.side_area_position_m;
  result.roll_damping_m4 = within_factor(damping_m4, roll_factor);
  if (canards) {
    add_canards(result, shape, *canards, fins);
  }
  add_masses(result, vehicle);
  return result;
}

}  // namespace fantail::airframe::model
