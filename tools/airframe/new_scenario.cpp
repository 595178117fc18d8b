// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "airframe/new_rocket.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::airframe {
namespace {

constexpr std::string_view scenario_text = R"(
vehicle = "vehicle.toml"
plan = "plan.toml"
seed = 1
assumed = ["{offset}"]

[verdict]
tilt_end_before_apogee_s = 10 # the plan's tilt limit may end control so early, and the roll still counts as held

[disturbance] # the fins push as hard as canards at this angle: measure it in a tunnel or find it in a flight
times_s = [0]
angles_deg = [{offset_deg}]

[flight]
motion = "{motion}"

[wind]
speed_m_s = {wind}{wind_spread}

# What fantail campaign draws: a table for each uncertain quantity. Uncomment this one, or write your own.
# [[spread]]
# field = "aerodynamics.torque_m"
# law = "uniform"
# effect = "factor"
# low = 0.5
# high = 2
)";

constexpr std::string_view wind_spread =
    "\n# speed_spread_m_s = 1.5 # standard deviation: fantail predict varies the wind";

}  // namespace

FinOffset fin_offset(const model::BuildUp& b) {
  constexpr double usual_deg = 3.0;
  constexpr double most_deg = 45.0;  // of a scenario
  const double cant_deg = b.roll_torque_m3 ? text::degrees(b.canted_torque_m3 / b.roll_torque_m3->value) : 0.0;
  if (cant_deg == 0.0) {
    return {usual_deg, "Fin offset: 3 deg, not measured."};
  }
  const std::string computed = fmt::format("{} deg, computed from the fins' cant", text::fixed(cant_deg, 1));
  return std::abs(cant_deg) <= most_deg
             ? FinOffset{cant_deg, fmt::format("Fin offset: {}.", computed)}
             : FinOffset{std::copysign(most_deg, cant_deg),
                         fmt::format("Fin offset: the largest that a scenario allows; computed: {}.", computed)};
}

std::string scenario_file(const FinOffset& offset, bool in_six_dof) {
  return fmt::format(fmt::runtime(scenario_text), fmt::arg("offset", offset.sentence),
                     fmt::arg("offset_deg", rounded(offset.angle_deg)),
                     fmt::arg("motion", in_six_dof ? "six_dof" : "straight"), fmt::arg("wind", in_six_dof ? 3 : 0),
                     fmt::arg("wind_spread", in_six_dof ? wind_spread : ""));
}

}  // namespace fantail::airframe
