// SPDX-License-Identifier: MIT
#include "fly/model_limits.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "flight/gate.hpp"
#include "fly/gravity_turn.hpp"
#include "sim/units.hpp"

namespace fantail::fly {
namespace {

constexpr double largest_constant_mach = 0.7;
static_assert(flight::model_ends_at_mach == sim::highest_mach_of_prandtl_glauert);

double degrees(double radians) { return radians / sim::radians_per_degree; }

std::optional<std::string> leaning_guide(const sim::Scenario& scenario, const flight::Flight& flight) {
  if (scenario.path || scenario.motion == sim::FlightMotion::six_dof || scenario.guide.tilt_rad < slight_tilt_rad ||
      !flight.events.apogee_s) {
    return std::nullopt;
  }
  const GravityTurn turn = gravity_turn(scenario);
  std::string text = fmt::format(
      "The guide leans by {:.0f} deg, and the simulated rocket stays on its line. A real one bends over: a point mass "
      "would reach {:.0f} m",
      degrees(scenario.guide.tilt_rad), turn.apogee_m);
  if (turn.tilt_limit_s) {
    text +=
        fmt::format(" and pass the plan's tilt limit of {:.0f} deg from {} {:.1f} s after lift-off, which ends control",
                    degrees(static_cast<double>(scenario.plan.run.tilt_limit.radians())),
                    flight::tilt_origin(scenario.plan), *turn.tilt_limit_s);
  }
  return text + ".";
}

std::optional<std::string> near_sound(const sim::Scenario& scenario, double top_mach, double speed_m_s) {
  const bool has_factor = scenario.vehicle.compressibility == sim::Compressibility::prandtl_glauert;
  const bool has_drag = scenario.vehicle.drag_over_mach.is_there();
  if (top_mach < largest_constant_mach) {
    return std::nullopt;
  }
  if (has_factor && top_mach < sim::highest_mach_of_prandtl_glauert) {
    return has_drag ? std::nullopt
                    : std::optional{fmt::format(
                          "At {:.0f} m/s, Mach {:.2f}, drag is no longer constant, as the simulation assumes.",
                          speed_m_s, top_mach)};
  }
  if (has_factor) {
    return fmt::format(
        "At {:.0f} m/s, Mach {:.2f}, damping, torque and normal force are unreliable, because their Prandtl-Glauert "
        "factor ends at Mach {:g}{}.",
        speed_m_s, top_mach, sim::highest_mach_of_prandtl_glauert,
        has_drag ? "" : "; so is the drag, whose coefficient is assumed to be constant");
  }
  return fmt::format(
      "At {:.0f} m/s, Mach {:.2f}, {}damping and torque are no longer constant, as the simulation assumes.", speed_m_s,
      top_mach, has_drag ? "" : "drag, ");
}

/// Counts in the tunnel, too, unless the air stands still.
std::optional<std::string> reversed_roll(const sim::Scenario& scenario) {
  const double wash = scenario.vehicle.canard_air.wash;
  if (wash < 1.0 || scenario.surroundings == sim::Surroundings::gimbal) {
    return std::nullopt;
  }
  return fmt::format(
      "The fins take back {:g} times the roll torque of the canards (aerodynamics.canard_wash), so {}. No gains of "
      "this control law hold the roll.",
      wash, wash > 1.0 ? "canard commands roll the rocket the opposite way" : "the canards do not roll the rocket");
}

/// The angle at which the air on a canard is as strong as its servo. The reach of the canards is not made from it: it
/// changes with the speed.
std::optional<std::string> weak_servo(const sim::Scenario& scenario, double largest_dynamic_pressure_pa) {
  const auto& torque_n_m = scenario.vehicle.servo.torque_n_m;
  const double hinge_m3 = scenario.vehicle.canard_air.hinge_moment_m3.value_or(0.0);
  const double load_n_m_per_rad = std::abs(hinge_m3) * largest_dynamic_pressure_pa;
  const double limit_rad = flight::canard_limit_rad(scenario.plan);
  if (!torque_n_m || *torque_n_m >= load_n_m_per_rad * limit_rad) {
    return std::nullopt;
  }
  return fmt::format(
      "At the highest dynamic pressure under control the air turns a canard {} beyond {:.1f} deg, where its moment "
      "equals the torque of the servo ({:g} N m). The authority and stability margins do not count that.",
      hinge_m3 > 0.0 ? "back" : "farther out", degrees(*torque_n_m / load_n_m_per_rad), *torque_n_m);
}

std::optional<std::string> strong_motor(const sim::Scenario& scenario, double largest_m_s2) {
  const double range_m_s2 =
      std::min(scenario.vehicle.imu.full_scale_m_s2, scenario.vehicle.accelerometer.full_scale_m_s2);
  // Noise takes a little of the range.
  if (largest_m_s2 < 0.98 * range_m_s2) {
    return std::nullopt;
  }
  const bool shakes = scenario.vehicle.vibration.specific_force_m_s2 > 0.0;
  return fmt::format("{} {:.1f} g or more; the ranges of the accelerometers are {:.0f} and {:.0f} g.",
                     shakes ? "An accelerometer measures thrust and vibration of" : "The motor pushes with",
                     largest_m_s2 / sim::gravity_m_s2, scenario.vehicle.imu.full_scale_m_s2 / sim::gravity_m_s2,
                     scenario.vehicle.accelerometer.full_scale_m_s2 / sim::gravity_m_s2);
}

/// From a beginning to an end, where the rocket was at least as fast as at that beginning; behind a gate, which may
/// open near top speed, as fast as off the guide.
const flight::PathPoint* largest_angle_of_attack(const flight::Flight& flight, const flight::PathPoint& begin,
                                                 const std::optional<double>& end_s) {
  const auto speed_m_s = [](const flight::PathPoint& p) { return std::hypot(p.north_m_s, p.east_m_s, p.up_m_s); };
  const flight::PathPoint* exit =
      flight::has_gate(flight) ? flight::point_at(flight.path, flight.events.guide_clear_s.value_or(0.0)) : nullptr;
  const double slowest_m_s = speed_m_s(exit != nullptr ? *exit : begin);
  const flight::PathPoint* largest = &begin;
  for (const flight::PathPoint& point : flight.path) {
    const bool counts =
        point.time_s >= begin.time_s && point.time_s <= end_s.value_or(point.time_s) && speed_m_s(point) >= slowest_m_s;
    largest = counts && point.angle_of_attack_rad > largest->angle_of_attack_rad ? &point : largest;
  }
  return largest;
}

/// The end of control, where it is known.
std::optional<double> control_or_apogee_s(const flight::Flight& flight) {
  return flight.events.control_end_s ? flight.events.control_end_s : flight.events.apogee_s;
}

/// In six degrees of freedom the flow that was there, else the one that the stated wind would make.
std::optional<std::string> wind_at_canards(const sim::Scenario& scenario, const flight::Flight& flight,
                                           const std::optional<double>& exit_speed_m_s) {
  const bool blows = scenario.wind.speed_m_s > 0.0 || scenario.wind.gust_m_s != 0.0;
  if (scenario.path || !blows || !exit_speed_m_s) {
    return std::nullopt;
  }
  std::string text;
  double angle_rad = std::atan2(scenario.wind.speed_m_s, *exit_speed_m_s);
  if (const flight::PathPoint* point = flight::point_at(flight.path, *flight.events.guide_clear_s)) {
    const flight::PathPoint* largest = largest_angle_of_attack(flight, *point, control_or_apogee_s(flight));
    angle_rad = largest->angle_of_attack_rad;
    text =
        fmt::format("The angle of attack is {:.0f} deg at the end of the guide", degrees(point->angle_of_attack_rad));
    if (largest != point && !flight::has_gate(flight) && flight.events.control_start_s) {
      text += fmt::format(", and up to {:.0f} deg later, at {:.2f} s", degrees(angle_rad), largest->time_s);
    }
  } else {
    text = fmt::format(
        "A wind of {:.3g} m/s, which is not simulated, meets the rocket at the end of its guide ({:.0f} m/s) at {:.0f} "
        "deg",
        scenario.wind.speed_m_s, *exit_speed_m_s, degrees(angle_rad));
  }
  if (!flight.events.control_start_s) {
    return text + ".";
  }
  if (flight::has_gate(flight)) {  // until then the canards stand at trim
    const auto start =
        std::ranges::lower_bound(flight.path, *flight.events.control_start_s, {}, &flight::PathPoint::time_s);
    if (start == flight.path.end()) {
      return text + ".";
    }
    const flight::PathPoint* largest = largest_angle_of_attack(flight, *start, control_or_apogee_s(flight));
    angle_rad = largest->angle_of_attack_rad;
    text += fmt::format(
        ", and up to {:.1f} deg under control, at {:.2f} s (flight slower than off the guide is not counted)",
        degrees(angle_rad), largest->time_s);
  }
  const double linear_angle_rad = scenario.vehicle.canard_air.stall_rad.value_or(flight::model_ends_at_attack_rad);
  const double limit_rad = flight::canard_limit_rad(scenario.plan);
  return angle_rad <= linear_angle_rad - limit_rad
             ? text + "."
             : text + fmt::format(
                          ": with {:.0f} deg of their own, the canards leave the linear range of about {:.0f} deg, and "
                          "their torque is less than simulated. Less wind, a faster exit from the guide or a smaller "
                          "canard limit reduces that.",
                          degrees(limit_rad), degrees(linear_angle_rad));
}

/// The centre of gravity moves to one side while the motor burns, so that the least margin is at one of its ends.
std::optional<double> least_margin_calibres(const std::optional<sim::Airframe>& airframe) {
  return airframe ? std::optional{std::min(static_margin_m(*airframe, airframe->at_liftoff),
                                           static_margin_m(*airframe, airframe->after_burnout)) /
                                  airframe->diameter_m}
                  : std::nullopt;
}

/// As wind_at_canards(), under control.
std::optional<double> attack_under_control_rad(const sim::Scenario& scenario, const flight::Flight& flight,
                                               const std::optional<double>& start_speed_m_s) {
  if (scenario.path || !start_speed_m_s || !flight.events.control_start_s) {
    return std::nullopt;
  }
  const auto start =
      std::ranges::lower_bound(flight.path, *flight.events.control_start_s, {}, &flight::PathPoint::time_s);
  if (start != flight.path.end()) {
    return largest_angle_of_attack(flight, *start, control_or_apogee_s(flight))->angle_of_attack_rad;
  }
  const double wind_m_s = scenario.wind.speed_m_s;
  return wind_m_s > 0.0 ? std::optional{std::atan2(wind_m_s, *start_speed_m_s)} : std::nullopt;
}

}  // namespace

void ModelLimits::add(const flight::Row& row, const flight::Flight& so_far) {
  const double height_m = row.truth->height_m;
  const double speed_m_s = row.truth->speed_m_s;
  if (row.phase == core::Phase::controlling) {
    start_speed_m_s_ = start_speed_m_s_.value_or(speed_m_s);
    const double density_kg_m3 =
        so_far.tunnel ? scenario_.tunnel.density_kg_m3 : scenario_.atmosphere.density_kg_m3(height_m);
    largest_dynamic_pressure_pa_ = std::max(largest_dynamic_pressure_pa_, 0.5 * density_kg_m3 * speed_m_s * speed_m_s);
  }
  if (const double mach = speed_m_s / scenario_.atmosphere.speed_of_sound_m_s(height_m); mach > top_mach_) {
    top_mach_ = mach;
    speed_at_top_mach_m_s_ = speed_m_s;
  }
  largest_specific_force_m_s2_ = std::max(largest_specific_force_m_s2_, row.specific_force_m_s2);
  if (so_far.events.guide_clear_s && !exit_speed_m_s_) {
    exit_speed_m_s_ = speed_m_s;
  }
}

flight::Extremes ModelLimits::extremes(const flight::Flight& flight) const {
  return {.top_mach = top_mach_,
          .static_margin_calibres = least_margin_calibres(scenario_.vehicle.airframe),
          .angle_of_attack_rad = attack_under_control_rad(scenario_, flight, start_speed_m_s_)};
}

std::vector<std::string> ModelLimits::gone_beyond(const flight::Flight& flight) const {
  std::vector<std::optional<std::string>> sentences{reversed_roll(scenario_),
                                                    weak_servo(scenario_, largest_dynamic_pressure_pa_)};
  if (!flight.tunnel) {
    sentences.insert(
        sentences.end(),
        {leaning_guide(scenario_, flight), near_sound(scenario_, top_mach_, speed_at_top_mach_m_s_),
         strong_motor(scenario_, largest_specific_force_m_s2_), wind_at_canards(scenario_, flight, exit_speed_m_s_)});
  }
  std::vector<std::string> all;
  for (std::optional<std::string>& sentence : sentences) {
    if (sentence) {
      all.push_back(std::move(*sentence));
    }
  }
  return all;
}

}  // namespace fantail::fly
