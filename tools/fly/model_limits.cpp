// SPDX-License-Identifier: MIT
#include "fly/model_limits.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "fly/gravity_turn.hpp"
#include "sim/units.hpp"
#include "stability/roll_loop.hpp"

namespace fantail::fly {
namespace {

constexpr double largest_constant_mach = 0.7;
// Where a vehicle does not say it, canards stall at about 15 degrees to the flow, of which the plan's limit is a part.
constexpr double usual_stall_rad = 15.0 * sim::radians_per_degree;

double degrees(double radians) { return radians / sim::radians_per_degree; }

std::optional<std::string> leaning_guide(const sim::Scenario& scenario, const flight::Flight& flight) {
  if (scenario.path || scenario.motion == sim::FlightMotion::six_dof || scenario.guide.tilt_rad < slight_tilt_rad ||
      !flight.events.apogee_s) {
    return std::nullopt;
  }
  const GravityTurn turn = gravity_turn(scenario);
  std::string text = fmt::format(
      "The guide leans by {:.0f} deg, and the simulated rocket keeps to its line. A real one bends over: a point mass "
      "would reach {:.0f} m",
      degrees(scenario.guide.tilt_rad), turn.apogee_m);
  if (turn.tilt_limit_s) {
    text += fmt::format(" and pass the plan's tilt limit of {:.0f} deg {:.1f} s after lift-off, which ends control",
                        degrees(static_cast<double>(scenario.plan.run.tilt_limit.radians())), *turn.tilt_limit_s);
  }
  return text + ".";
}

std::optional<std::string> near_sound(const sim::Scenario& scenario, const flight::Flight& flight) {
  double top_mach = 0.0;
  double speed_m_s = 0.0;
  for (const flight::Row& row : flight.rows) {
    const double mach = row.truth->speed_m_s / scenario.atmosphere.speed_of_sound_m_s(row.truth->height_m);
    if (mach > top_mach) {
      top_mach = mach;
      speed_m_s = row.truth->speed_m_s;
    }
  }
  const bool has_factor = scenario.vehicle.compressibility == sim::Compressibility::prandtl_glauert;
  const bool has_drag = scenario.vehicle.drag_over_mach.is_there();
  if (top_mach < largest_constant_mach) {
    return std::nullopt;
  }
  if (has_factor && top_mach < sim::highest_mach_of_prandtl_glauert) {
    return has_drag ? std::nullopt
                    : std::optional{fmt::format(
                          "At {:.0f} m/s, Mach {:.2f}, drag is no longer constant, as the simulation takes it to be.",
                          speed_m_s, top_mach)};
  }
  if (has_factor) {
    return fmt::format(
        "At {:.0f} m/s, Mach {:.2f}, nothing is promised of damping, torque and normal force: their Prandtl-Glauert "
        "factor ends at Mach {:g}{}.",
        speed_m_s, top_mach, sim::highest_mach_of_prandtl_glauert,
        has_drag ? "" : "; nor of the drag, whose coefficient is taken to be constant");
  }
  return fmt::format(
      "At {:.0f} m/s, Mach {:.2f}, {}damping and torque are no longer constant, as the simulation takes them to be.",
      speed_m_s, top_mach, has_drag ? "" : "drag, ");
}

/// Counts in the tunnel, too, unless the air stands still.
std::optional<std::string> reversed_roll(const sim::Scenario& scenario) {
  const double wash = scenario.vehicle.canard_air.wash;
  if (wash < 1.0 || scenario.surroundings == sim::Surroundings::gimbal) {
    return std::nullopt;
  }
  return fmt::format(
      "The fins take back {:g} times the roll torque of the canards (aerodynamics.canard_wash), so {}: no gains of "
      "this "
      "control law hold the roll.",
      wash, wash > 1.0 ? "canards that turn one way roll the rocket the other way" : "the canards turn nothing");
}

double largest_dynamic_pressure_pa(const sim::Scenario& scenario, const flight::Flight& flight) {
  double largest_pa = 0.0;
  for (const flight::Row& row : flight.rows) {
    const double density_kg_m3 =
        flight.tunnel ? scenario.tunnel.density_kg_m3 : scenario.atmosphere.density_kg_m3(row.truth->height_m);
    if (row.phase == core::Phase::controlling) {
      largest_pa = std::max(largest_pa, 0.5 * density_kg_m3 * row.truth->speed_m_s * row.truth->speed_m_s);
    }
  }
  return largest_pa;
}

/// The angle at which the air on a canard is as strong as its servo. The reach of the canards is not made from it: it
/// changes with the speed.
std::optional<std::string> weak_servo(const sim::Scenario& scenario, const flight::Flight& flight) {
  const auto& torque_n_m = scenario.vehicle.servo.torque_n_m;
  const double hinge_m3 = scenario.vehicle.canard_air.hinge_moment_m3.value_or(0.0);
  const double load_n_m_per_rad = std::abs(hinge_m3) * largest_dynamic_pressure_pa(scenario, flight);
  const double limit_rad = flight::canard_limit_rad(scenario.plan);
  if (!torque_n_m || *torque_n_m >= load_n_m_per_rad * limit_rad) {
    return std::nullopt;
  }
  return fmt::format(
      "At the highest dynamic pressure under control the air turns a canard {} beyond {:.1f} deg, where its moment is "
      "all that the servo has ({:g} N m); authority and stability margins do not count that.",
      hinge_m3 > 0.0 ? "back" : "farther out", degrees(*torque_n_m / load_n_m_per_rad), *torque_n_m);
}

std::optional<std::string> strong_motor(const sim::Scenario& scenario, const flight::Flight& flight) {
  double largest_m_s2 = 0.0;
  for (const flight::Row& row : flight.rows) {
    largest_m_s2 = std::max(largest_m_s2, row.specific_force_m_s2);
  }
  const double range_m_s2 =
      std::min(scenario.vehicle.imu.full_scale_m_s2, scenario.vehicle.accelerometer.full_scale_m_s2);
  // Noise takes a little of the range.
  if (largest_m_s2 < 0.98 * range_m_s2) {
    return std::nullopt;
  }
  const bool shakes = scenario.vehicle.vibration.specific_force_m_s2 > 0.0;
  return fmt::format("{} {:.1f} g or more; the ranges of the accelerometers are {:.0f} and {:.0f} g.",
                     shakes ? "An accelerometer feels thrust and vibration of" : "The motor pushes with",
                     largest_m_s2 / sim::gravity_m_s2, scenario.vehicle.imu.full_scale_m_s2 / sim::gravity_m_s2,
                     scenario.vehicle.accelerometer.full_scale_m_s2 / sim::gravity_m_s2);
}

/// Where the rocket was at least as fast as at the end of its guide, from there to apogee.
const flight::PathPoint* largest_angle_of_attack(const flight::Flight& flight, const flight::PathPoint& exit) {
  const auto speed_m_s = [](const flight::PathPoint& p) { return std::hypot(p.north_m_s, p.east_m_s, p.up_m_s); };
  const flight::PathPoint* largest = &exit;
  for (const flight::PathPoint& point : flight.path) {
    const bool counts = point.time_s >= exit.time_s && point.time_s <= flight.events.apogee_s.value_or(point.time_s) &&
                        speed_m_s(point) >= speed_m_s(exit);
    largest = counts && point.angle_of_attack_rad > largest->angle_of_attack_rad ? &point : largest;
  }
  return largest;
}

/// In six degrees of freedom the flow that was there, else the one that the stated wind would make.
std::optional<std::string> wind_at_canards(const sim::Scenario& scenario, const flight::Flight& flight) {
  const bool blows = scenario.wind.speed_m_s > 0.0 || scenario.wind.gust_m_s != 0.0;
  if (scenario.path || !blows || !flight.events.guide_clear_s) {
    return std::nullopt;
  }
  const auto exit = std::ranges::find_if(
      flight.rows, [&](const flight::Row& row) { return row.time_s >= *flight.events.guide_clear_s; });
  if (exit == flight.rows.end()) {
    return std::nullopt;
  }
  std::string text;
  double angle_rad = std::atan2(scenario.wind.speed_m_s, exit->truth->speed_m_s);
  if (const flight::PathPoint* point = flight::point_at(flight.path, *flight.events.guide_clear_s)) {
    const flight::PathPoint* largest = largest_angle_of_attack(flight, *point);
    angle_rad = largest->angle_of_attack_rad;
    text = fmt::format("The air meets the rocket at {:.0f} deg at the end of its guide",
                       degrees(point->angle_of_attack_rad));
    if (largest != point) {
      text += fmt::format(", and at up to {:.0f} deg later, at {:.2f} s", degrees(angle_rad), largest->time_s);
    }
  } else {
    text = fmt::format(
        "A wind of {:.3g} m/s, which is not simulated, meets the rocket at the end of its guide ({:.0f} m/s) at {:.0f} "
        "deg",
        scenario.wind.speed_m_s, exit->truth->speed_m_s, degrees(angle_rad));
  }
  const double linear_angle_rad = scenario.vehicle.canard_air.stall_rad.value_or(usual_stall_rad);
  const double limit_rad = flight::canard_limit_rad(scenario.plan);
  return angle_rad <= linear_angle_rad - limit_rad
             ? text + "."
             : text + fmt::format(
                          ": with {:.0f} deg of their own the canards leave the linear range of about {:.0f} deg, and "
                          "their torque is less than simulated.",
                          degrees(limit_rad), degrees(linear_angle_rad));
}

}  // namespace

std::vector<std::string> beyond_the_model(const sim::Scenario& scenario, const flight::Flight& flight) {
  std::vector<std::optional<std::string>> sentences{reversed_roll(scenario), weak_servo(scenario, flight)};
  if (!flight.tunnel) {
    sentences.insert(sentences.end(), {leaning_guide(scenario, flight), near_sound(scenario, flight),
                                       strong_motor(scenario, flight), wind_at_canards(scenario, flight)});
  }
  std::vector<std::string> all;
  for (std::optional<std::string>& sentence : sentences) {
    if (sentence) {
      all.push_back(std::move(*sentence));
    }
  }
  return all;
}

std::vector<double> speeds_under_control_m_s(const flight::Flight& flight) {
  std::vector<double> all;
  for (const flight::Row& row : flight.rows) {
    if (row.phase == core::Phase::controlling) {
      all.push_back(row.truth->speed_m_s);
    }
  }
  if (!all.empty()) {
    const double lowest_m_s = all.front();
    std::erase_if(all, [lowest_m_s](double speed_m_s) { return speed_m_s < lowest_m_s; });
  }
  return all;
}

std::optional<stability::SpeedRange> speed_range_under_control(const flight::Flight& flight) {
  const std::vector<double> all = speeds_under_control_m_s(flight);
  return all.empty() ? std::nullopt : std::optional{stability::SpeedRange{all.front(), std::ranges::max(all)}};
}

std::vector<flight::LoopMargin> loop_margins(const sim::Scenario& scenario, const flight::Flight& flight) {
  std::vector<double> speeds_m_s = speeds_under_control_m_s(flight);
  if (speeds_m_s.empty()) {
    return {};
  }
  const double lowest_m_s = speeds_m_s.front();
  const double top_m_s = std::ranges::max(speeds_m_s);
  const auto middle = speeds_m_s.begin() + std::ssize(speeds_m_s) / 2;
  std::ranges::nth_element(speeds_m_s, middle);
  const double median_m_s = *middle;

  const auto at = [&scenario](double speed_m_s) -> std::optional<flight::LoopMargin> {
    const auto found = stability::margins(stability::loop_at_speed(scenario, speed_m_s));
    return found ? std::optional{flight::LoopMargin{speed_m_s, found->phase_margin_rad, found->gain_margin,
                                                    found->crossover_rad_s}}
                 : std::nullopt;
  };
  double worst_m_s = lowest_m_s;
  std::optional<double> least_rad;
  constexpr int steps = 32;
  for (const double speed_m_s : stability::speeds_between(scenario.plan, {lowest_m_s, top_m_s}, steps)) {
    const auto found_rad = stability::phase_margin_rad(stability::loop_at_speed(scenario, speed_m_s));
    if (found_rad && (!least_rad || *found_rad < *least_rad)) {
      worst_m_s = speed_m_s;
      least_rad = found_rad;
    }
  }
  std::vector<flight::LoopMargin> all;
  for (const double speed_m_s : {lowest_m_s, median_m_s, top_m_s, worst_m_s}) {
    const auto found = at(speed_m_s);
    const auto known = [&](const flight::LoopMargin& other) { return other.speed_m_s == found->speed_m_s; };
    if (found && std::ranges::none_of(all, known)) {
      all.push_back(*found);
    }
  }
  std::ranges::sort(all, {}, &flight::LoopMargin::speed_m_s);
  return all;
}

}  // namespace fantail::fly
