// SPDX-License-Identifier: MIT
#include "fly/model_limits.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "fly/gravity_turn.hpp"
#include "sim/units.hpp"
#include "stability/roll_loop.hpp"

namespace fantail::fly {
namespace {

constexpr double speed_of_sound_m_s = 340.3;  // at 15 degrees Celsius; at 5 km it is 320
constexpr double largest_mach = 0.7;
// Canards stall at about 15 degrees to the flow, of which the plan's limit is a part.
constexpr double linear_angle_rad = 15.0 * sim::radians_per_degree;

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

std::optional<std::string> near_sound(const flight::Flight& flight) {
  double top_m_s = 0.0;
  for (const flight::Row& row : flight.rows) {
    top_m_s = std::max(top_m_s, row.truth->speed_m_s);
  }
  if (top_m_s < largest_mach * speed_of_sound_m_s) {
    return std::nullopt;
  }
  return fmt::format(
      "At {:.0f} m/s, Mach {:.2f}, drag, damping and torque are no longer constant, as the simulation "
      "takes them to be.",
      top_m_s, top_m_s / speed_of_sound_m_s);
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
  return fmt::format(
      "The motor pushes with {:.1f} g or more; the ranges of the accelerometers are {:.0f} and {:.0f} g.",
      largest_m_s2 / sim::gravity_m_s2, scenario.vehicle.imu.full_scale_m_s2 / sim::gravity_m_s2,
      scenario.vehicle.accelerometer.full_scale_m_s2 / sim::gravity_m_s2);
}

/// In six degrees of freedom the flow that was there, else the one that the stated wind would make.
std::optional<std::string> windy_exit(const sim::Scenario& scenario, const flight::Flight& flight) {
  if (scenario.path || !(scenario.wind.speed_m_s > 0.0) || !flight.events.guide_clear_s) {
    return std::nullopt;
  }
  const auto exit = std::ranges::find_if(
      flight.rows, [&](const flight::Row& row) { return row.time_s >= *flight.events.guide_clear_s; });
  if (exit == flight.rows.end()) {
    return std::nullopt;
  }
  const flight::PathPoint* point = flight::point_at(flight.path, *flight.events.guide_clear_s);
  const double angle_rad =
      point != nullptr ? point->angle_of_attack_rad : std::atan2(scenario.wind.speed_m_s, exit->truth->speed_m_s);
  const double left_rad = linear_angle_rad - flight::canard_limit_rad(scenario.plan);
  const std::string text =
      fmt::format("A wind of {:.3g} m/s{} meets the rocket at the end of its guide ({:.0f} m/s) at {:.0f} deg",
                  scenario.wind.speed_m_s, point != nullptr ? "" : ", which is not simulated,", exit->truth->speed_m_s,
                  degrees(angle_rad));
  return angle_rad <= left_rad
             ? text + "."
             : text + fmt::format(
                          ": with {:.0f} deg of their own the canards leave the linear range of about {:.0f} "
                          "deg, and their torque is less than simulated.",
                          degrees(flight::canard_limit_rad(scenario.plan)), degrees(linear_angle_rad));
}

}  // namespace

std::vector<std::string> beyond_the_model(const sim::Scenario& scenario, const flight::Flight& flight) {
  std::vector<std::string> all;
  if (flight.tunnel) {
    return all;
  }
  for (const auto& sentence : {leaning_guide(scenario, flight), near_sound(flight), strong_motor(scenario, flight),
                               windy_exit(scenario, flight)}) {
    if (sentence) {
      all.push_back(*sentence);
    }
  }
  return all;
}

std::vector<flight::LoopMargin> loop_margins(const sim::Scenario& scenario, const flight::Flight& flight) {
  std::vector<double> speeds_m_s;
  for (const flight::Row& row : flight.rows) {
    if (row.phase == core::Phase::controlling) {
      speeds_m_s.push_back(row.truth->speed_m_s);
    }
  }
  if (speeds_m_s.empty()) {
    return {};
  }
  // Near apogee nothing flows: the lowest speed that counts is that at which control began.
  const double begin_m_s = speeds_m_s.front();
  std::ranges::sort(speeds_m_s);
  const auto first = std::ranges::lower_bound(speeds_m_s, begin_m_s);
  const double lowest_m_s = *first;
  const double median_m_s = *(first + (speeds_m_s.end() - first) / 2);
  const double top_m_s = speeds_m_s.back();

  const auto at = [&scenario](double speed_m_s) -> std::optional<flight::LoopMargin> {
    const auto found = stability::margins(stability::loop_at_speed(scenario, speed_m_s));
    return found ? std::optional{flight::LoopMargin{speed_m_s, found->phase_margin_rad, found->gain_margin}}
                 : std::nullopt;
  };
  std::optional<flight::LoopMargin> worst;
  constexpr int steps = 32;
  for (int i = 0; i <= steps; ++i) {
    const auto found = at(lowest_m_s + (top_m_s - lowest_m_s) * i / steps);
    worst = found && (!worst || found->phase_margin_rad < worst->phase_margin_rad) ? found : worst;
  }
  std::vector<flight::LoopMargin> all;
  for (const auto& found : {at(lowest_m_s), at(median_m_s), at(top_m_s), worst}) {
    const auto known = [&](const flight::LoopMargin& other) { return other.speed_m_s == found->speed_m_s; };
    if (found && std::ranges::none_of(all, known)) {
      all.push_back(*found);
    }
  }
  std::ranges::sort(all, {}, &flight::LoopMargin::speed_m_s);
  return all;
}

}  // namespace fantail::fly
