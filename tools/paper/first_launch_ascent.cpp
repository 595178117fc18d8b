// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "paper/recomputed.hpp"
#include "sim/units.hpp"

namespace fantail::paper {
namespace {

constexpr double printed_apogee_m = 522.0;
constexpr double printed_top_speed_m_s = 97.0;
constexpr double printed_control_start_s = 0.63;
constexpr double printed_control_height_m = 7.0;

// Whether the printed time is possible at all. The densest air and the lightest rocket make the shortest coast.
std::string time_to_apogee_reason(const sim::Vehicle& vehicle) {
  constexpr double sea_level_kg_m3 = 1.225;
  const double empty_kg = vehicle.mass_kg - vehicle.motor.propellant_kg();
  const Coasting coasting{.drag_per_mass_1_m = 0.5 * sea_level_kg_m3 * vehicle.drag_area_m2 / empty_kg};
  const double at_once_s = least_time_to_apogee_s(printed_apogee_m, printed_top_speed_m_s, coasting);
  const double behind_control_s =
      printed_control_start_s +
      least_time_to_apogee_s(printed_apogee_m - printed_control_height_m, printed_top_speed_m_s, coasting);
  return fmt::format(
      "Our motor thrusts once and then coasts. Height and speed alone allow 10.2 s. A motor that makes 97 m/s at once "
      "and holds it (boost and sustain) needs at least {:.2f} s with our drag area. One that is 7 m up after 0.63 s, "
      "as printed, needs at least {:.2f} s. So these figures contradict each other, unless the drag area is larger "
      "than ours.",
      at_once_s, behind_control_s);
}

}  // namespace

double least_time_to_apogee_s(double height_m, double top_speed_m_s, const Coasting& coasting) {
  constexpr double g = sim::gravity_m_s2;
  // The speed at which drag equals weight; the coast's closed forms are written in it.
  const double terminal_m_s = std::sqrt(g / coasting.drag_per_mass_1_m);
  const double scale_m = terminal_m_s * terminal_m_s / (2.0 * g);
  const double speed_to_coast_all_m_s = terminal_m_s * std::sqrt(std::expm1(height_m / scale_m));
  const double speed_m_s = std::min(top_speed_m_s, speed_to_coast_all_m_s);
  const double ratio = speed_m_s / terminal_m_s;
  const double coast_m = scale_m * std::log1p(ratio * ratio);
  const double coast_s = terminal_m_s / g * std::atan(ratio);
  return coast_s + (height_m - coast_m) / speed_m_s;
}

std::vector<Claim> first_launch_ascent(const Run& run, const report::Figures& figures) {
  const flight::Flight& flight = run.flight;
  const std::string motor =
      "With a motor of the I150 class and the drag area that fits both launches; the motor is not named.";
  const std::string origin =
      "The height is counted from launch detection, with the speed gained before it: the one of two ways to count that "
      "meets the printed figures.";
  const std::string place = "Section 4.2";
  const auto fitted = [&](Numbers numbers) {
    numbers.kind = Kind::fitted;
    return compare(numbers);
  };
  return {fitted({.place = place,
                  .what = "Apogee",
                  .theirs = printed_apogee_m,
                  .ours = *figures.apogee_m,
                  .unit = "m",
                  .decimals = 1,
                  .tolerance = 0.02 * printed_apogee_m,
                  .remark = motor}),
          fitted({.place = place,
                  .what = "Highest speed",
                  .theirs = printed_top_speed_m_s,
                  .ours = *figures.max_speed_m_s,
                  .unit = "m/s",
                  .decimals = 1,
                  .tolerance = 0.02 * printed_top_speed_m_s,
                  .remark = motor}),
          fitted({.place = place,
                  .what = "Time to apogee",
                  .theirs = 10.2,
                  .ours = *flight.events.apogee_s,
                  .unit = "s",
                  .decimals = 2,
                  .tolerance = 0.1,
                  .why_otherwise = time_to_apogee_reason(run.scenario.vehicle)}),
          fitted({.place = place,
                  .what = "Control starts, after lift-off",
                  .theirs = printed_control_start_s,
                  .ours = *flight.events.control_start_s,
                  .unit = "s",
                  .decimals = 3,
                  .tolerance = 0.015,
                  .remark = origin}),
          fitted({.place = place,
                  .what = "Height at control start",
                  .theirs = printed_control_height_m,
                  .ours = *figures.control_start_height_m,
                  .unit = "m",
                  .decimals = 2,
                  .tolerance = 0.35,
                  .remark = "One metre above the rule's six. " + origin}),
          fitted({.place = "Eq 31",
                  .what = "T_PD: from launch detection to control start",
                  .theirs = 0.42,
                  .ours = *flight.events.control_start_s - *flight.events.detected_s,
                  .unit = "s",
                  .decimals = 3,
                  .tolerance = 0.015,
                  .remark = origin}),
          fitted({.place = place,
                  .what = "Oscillation before the canards stay at their limit, after control start: about",
                  .theirs = 1.0,
                  .ours = *figures.at_limit_since_s - *flight.events.control_start_s,
                  .unit = "s",
                  .decimals = 2,
                  .tolerance = 0.25,
                  .remark = "Its reference area and roll state were fitted to the swing before it, in figure 21a."})};
}

}  // namespace fantail::paper
