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

# What nobody knows before the launch, for fantail campaign; a flight has the values as they stand. Damping, torque and
# centre of pressure: the error of what is computed from a shape. The rest is assumed: narrow it as you measure.
[[spread]]
field = "aerodynamics.damping_m2"
law = "uniform"
effect = "factor"
low = 0.5
high = 2

{torque_spread}[[spread]]
field = "disturbance.angles_deg"
law = "normal"
effect = "offset"
standard_deviation = 1

[[spread]]
field = "body.mass_kg"
law = "normal"
effect = "factor"
standard_deviation = 0.02

[[spread]]
field = "body.drag_area_m2"
law = "normal"
effect = "factor"
standard_deviation = 0.15

[[spread]]
field = "motor.thrust_factor"
law = "normal"
standard_deviation = 0.03

[[spread]]
field = "servo.lag_s"
law = "triangular"
effect = "factor"
low = 0.7
mode = 1
high = 1.6

[[spread]]
field = "imu.rate_bias_deg_s"
law = "normal"
standard_deviation = 0.3
{side_spread})";

constexpr std::string_view torque_spread = R"([[spread]]
field = "aerodynamics.torque_m"
law = "uniform"
effect = "factor"
low = 0.5
high = 2

)";

constexpr std::string_view side_spread = R"(
[[spread]]
field = "airframe.centre_of_pressure_m"
law = "uniform"
effect = "factor"
low = 0.97
high = 1.03

[[spread]]
field = "wind.speed_m_s"
law = "uniform"
low = 0
high = 6

[[spread]]
field = "wind.from_deg"
law = "uniform"
low = 0
high = 360
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

std::string scenario_file(const FinOffset& offset, bool in_six_dof, bool has_canards) {
  return fmt::format(fmt::runtime(scenario_text), fmt::arg("offset", offset.sentence),
                     fmt::arg("offset_deg", rounded(offset.angle_deg)),
                     fmt::arg("motion", in_six_dof ? "six_dof" : "straight"), fmt::arg("wind", in_six_dof ? 3 : 0),
                     fmt::arg("wind_spread", in_six_dof ? wind_spread : ""),
                     fmt::arg("torque_spread", has_canards ? torque_spread : ""),
                     fmt::arg("side_spread", in_six_dof ? side_spread : ""));
}

}  // namespace fantail::airframe
