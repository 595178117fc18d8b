// SPDX-License-Identifier: MIT
#include "input/scenario_file.hpp"

namespace fantail::input {
namespace {

constexpr std::array<std::string_view, 3> surroundings{"flight", "tunnel", "gimbal"};
constexpr std::array<std::string_view, 2> motions{"straight", "six_dof"};
constexpr std::array<std::string_view, 2> guide_rolls{"free", "held"};
constexpr std::array<std::string_view, 3> densities{"exponential", "isa", "constant"};
constexpr std::size_t most_points = 1000;

// clang-format off: one field a row reads better than one argument a line
#define AT(expression) FANTAIL_PLACE(sim::Scenario, expression)
constexpr auto fields = std::to_array<Field<sim::Scenario>>({
  {"", "vehicle", file(), must, AT(it.vehicle_name), "The vehicle that flies."},
  {"", "plan", file(), must, AT(it.plan_name), "The flight plan of its avionics."},
  {"", "seed", integer({}, {0, 9e15}), may, AT(it.seed), "Seed of every random stream."},
  {"", "assumed", list(100, text()), may, AT(grown(it.assumed, i)), "Assumptions in this file that were not measured, one sentence each; reports repeat them."},
  {"", "tunnel_result", file(), may, {}, "The tunnel result from which [`predict`](predict.md) starts."},

  {"environment", "surroundings", choice(surroundings), may, AT(it.surroundings), "`tunnel` or `gimbal` for plans with `run.start = \"tunnel\"`, and only for them. `gimbal`: in a frame of three rings, turned by hand."},
  {"environment", "density", choice(densities), may, AT(it.atmosphere.model), "Air density over height: 1.225 kg/m3 exp(-h / 8500 m), the International Standard Atmosphere, or constant. Not for the tunnel."},
  {"environment", "density_kg_m3", number("kg/m3", {0.01, 5}), may, AT(it.atmosphere.constant_kg_m3), "Air density for `constant`, in flight."},
  {"environment", "site_elevation_m", number("m", {-500, 6000}), may, AT(it.atmosphere.elevation_m), "Elevation of the launch site above sea level, for `exponential`, `isa` and the barometer."},
  {"environment", "air_temperature_c", number("C", {-60, 60}), may, AT(it.atmosphere.air_temperature_c), "Air temperature at the launch site, in degrees Celsius, for the barometer only: in cold air it reads too high a height. Absent: that of the standard atmosphere, 15 at sea level."},

  {"flight", "motion", choice(motions), may, AT(it.motion), "`straight`: along the line of the guide. `six_dof`: six degrees of freedom, in the wind; needs the vehicle's section `[airframe]`."},

  {"wind", "speed_m_s", number("m/s", {0, 30}), may, AT(it.wind.speed_m_s), "Wind speed at the reference height, for `six_dof`. Along a straight line reports only say where it matters."},
  {"wind", "from_deg", number(deg, {0, 360}), may, AT(it.wind.from_rad), "Direction from which the wind comes: 0 north, 90 east. For `six_dof` only, like all keys of [wind] below."},
  {"wind", "reference_height_m", number("m", {1, 1000}), may, AT(it.wind.reference_height_m), "Height above the ground for `speed_m_s`."},
  {"wind", "exponent", number("", {0, 1}), may, AT(it.wind.exponent), "The speed grows with this power of the height; 0.14 over open land."},
  {"wind", "gust_m_s", number("m/s", {-30, 30}), may, AT(it.wind.gust_m_s), "Peak speed of one gust that rises and falls as a cosine; below zero: against the wind."},
  {"wind", "gust_time_s", number("s", {0, 600}), may, AT(it.wind.gust_time_s), "Start of the gust, after ignition."},
  {"wind", "gust_duration_s", number("s", {0.05, 60}), may, AT(it.wind.gust_duration_s), "Duration of the gust."},
  {"wind", "turbulence", number("", {0, 0.5}), may, AT(it.wind.turbulence), "Dryden turbulence: standard deviation of each horizontal component over the speed; 0.1 to 0.2 are usual."},
  {"wind", "speed_spread_m_s", number("m/s", {0, 15}), may, AT(it.wind_spread.speed_m_s), "For `predict`, which draws a wind for each run: standard deviation of `speed_m_s`."},
  {"wind", "direction_spread_deg", number(deg, {0, 180}), may, AT(it.wind_spread.direction_rad), "For `predict`: the wind comes from any direction within this angle of `from_deg` with equal probability."},

  {"launch_guide", "tilt_deg", number(deg, {0, 15}), may, AT(it.guide.tilt_rad), "Tilt from the vertical."},
  {"launch_guide", "length_m", number("m", {0.5, 50}), may, AT(it.guide.length_m), "True length; the plan's when absent."},
  {"launch_guide", "azimuth_deg", number(deg, {0, 360}), may, AT(it.guide.azimuth_rad), "Direction in which it leans: 0 north, 90 east. For `six_dof` only, like all keys of [launch_guide] below."},
  {"launch_guide", "friction", number("", {0, 1}), may, AT(it.guide.friction), "Friction force along the guide over the force across it."},
  {"launch_guide", "tip_off_deg_s", number(deg_s, {-200, 200}), may, AT(it.guide.tip_off_rad_s), "Pitch rate with which the rocket leaves, towards the side that the guide leans to."},
  {"launch_guide", "roll", choice(guide_rolls), may, AT(it.guide.roll), "`free`: a tower, in which a rocket can roll. `held`: a rail with buttons."},

  {"tunnel", "fan_rpm", number("rpm", {0, 3000}), may, AT(it.tunnel.fan_rpm), "Fan speed until the first of `fan_times_s`."},
  {"tunnel", "speed_per_rpm_m_s", number("m/s per rpm", {0.001, 0.1}), may, AT(it.tunnel.speed_per_rpm_m_s), "Air speed over fan speed; 0.0176 gives 22 m/s at 1250 rpm."},
  {"tunnel", "turbulence", number("", {0, 0.5}), may, AT(it.tunnel.turbulence), "Standard deviation of the air speed over its mean."},
  {"tunnel", "turbulence_time_s", number("s", {0.01, 60}), may, AT(it.tunnel.turbulence_time_s), "Correlation time of the turbulence."},
  {"tunnel", "fan_lag_s", number("s", {0.1, 600}), may, AT(it.tunnel.fan_lag_s), "Time constant with which the air speed follows the fan."},
  {"tunnel", "swirl_deg", number(deg, {-20, 20}), may, AT(it.tunnel.swirl_rad), "Swirl as an equivalent canard angle, above zero clockwise seen from the tail; added to the disturbance."},
  {"tunnel", "density_kg_m3", number("kg/m3", {0.01, 5}), may, AT(it.tunnel.density_kg_m3), "Density of the air in the tunnel."},
  {"tunnel", "fan_times_s", list(most_points, number("s", {0, 3600})), may, AT(grown(it.fan_programme, i).time_s), "Fan programme: times of the changes, after the start command; increasing."},
  {"tunnel", "fan_rpms", list(most_points, number("rpm", {0, 3000})), may, AT(grown(it.fan_programme, i).fan_rpm), "Fan programme: fan speed from each of these times on; as many as `fan_times_s`."},
  {"tunnel", "wind_sensor_period_s", number("s", {0.001, 600}), may, AT(it.wind_sensor.period_s), "Time between two readings in `tunnel.csv`."},
  {"tunnel", "wind_sensor_resolution_m_s", number("m/s", {0, 5}), may, AT(it.wind_sensor.resolution_m_s), "Step to which the readings are rounded; 0: not rounded."},

  {"tunnel_pin", "in_front_m", number("m", {-0.5, 0.5}), may, AT(made(it.pin).in_front_m), "The rocket is pinned to two strings, free in pitch and held in roll: distance of the pins in front of its centre of gravity. Needs the vehicle's section `[airframe]`."},
  {"tunnel_pin", "stiffness_n_m_per_rad", number("N m/rad", {0, 100}), may, AT(made(it.pin).stiffness_n_m_per_rad), "Stiffness of the strings in twist."},
  {"tunnel_pin", "friction_n_m_s", number("N m s", {0, 10}), may, AT(made(it.pin).friction_n_m_s), "Friction of the strings, per rate."},
  {"tunnel_pin", "tether_slack_deg", number(deg, {1, 180}), may, AT(made(it.pin).tether_slack_rad), "Beyond this angle a safety tether pulls the rocket back."},
  {"tunnel_pin", "tether_n_m_per_rad", number("N m/rad", {0, 1000}), may, AT(made(it.pin).tether_n_m_per_rad), "Stiffness of the tether."},
  {"tunnel_pin", "wall_deg", number(deg, {1, 180}), may, AT(made(it.pin).wall_rad), "At this angle the wall stops the rocket."},
  {"tunnel_pin", "kick_times_s", list(most_points, number("s", {0, 3600})), may, AT(grown(made(it.pin).kicks, i).time_s), "Times at which the rocket is pushed, after the start command; increasing."},
  {"tunnel_pin", "kick_rates_deg_s", list(most_points, number(deg_s, {-500, 500})), may, AT(grown(made(it.pin).kicks, i).rate_rad_s), "Rate that each push adds; as many as `kick_times_s`."},

  {"gimbal", "turn_times_s", list(most_points, number("s", {0, 3600})), may, AT(grown(it.hand_turns, i).time_s), "Times after power-up at which the rocket is turned by hand; increasing, each after the previous turn. The self-test needs 7 s of rest."},
  {"gimbal", "turn_durations_s", list(most_points, number("s", {0.1, 600})), may, AT(grown(it.hand_turns, i).duration_s), "Duration of each turn; as many as `turn_times_s`, like the lists below."},
  {"gimbal", "turn_roll_deg", list(most_points, number(deg, {-720, 720})), may, AT(grown(it.hand_turns, i).angle_rad.x), "Angle of each turn about the long axis; positive: clockwise, seen from the tail."},
  {"gimbal", "turn_pitch_deg", list(most_points, number(deg, {-720, 720})), may, AT(grown(it.hand_turns, i).angle_rad.y), "Angle about y at the same time."},
  {"gimbal", "turn_yaw_deg", list(most_points, number(deg, {-720, 720})), may, AT(grown(it.hand_turns, i).angle_rad.z), "Angle about z at the same time."},
  {"gimbal", "friction_n_m", number("N m", {0, 10}), may, AT(it.gimbal_friction_n_m), "Friction of the bearings. With it, the hands let go half-way through each turn, and the rocket turns freely until friction or the next turn stops it. Needs the vehicle's section `[airframe]`."},

  {"disturbance", "times_s", list(most_points, number("s", {0, 3600})), may, AT(grown(it.disturbance, i).time_s), "Equivalent fin offset: increasing times after lift-off (tunnel: after control start)."},
  {"disturbance", "angles_deg", list(most_points, number(deg, {-45, 45})), may, AT(grown(it.disturbance, i).angle_rad), "Its angle at each of those times; straight lines between them, constant beyond."},

  {"imposed_roll", "time_s", number("s", {0, 3600}), must_in_its_section, AT(made(it.imposed_roll).time_s), "Time after lift-off at which roll angle and rate are set once, for a transient that no model explains."},
  {"imposed_roll", "angle_deg", number(deg, {-3600, 3600}), must_in_its_section, AT(made(it.imposed_roll).angle_rad), "Roll angle from then on."},
  {"imposed_roll", "rate_deg_s", number(deg_s, {-3600, 3600}), must_in_its_section, AT(made(it.imposed_roll).rate_rad_s), "Roll rate from then on."},

  {"verdict", "rest_limit_deg", number(deg, {0.1, 3600}), may, AT(it.rest_limit_rad), "Largest angle from the reference at which a settled roll angle still counts as `held`."},
  {"verdict", "tilt_end_before_apogee_s", number("s", {0.5, 60}), may, AT(it.tilt_end_before_apogee_s), "The plan's tilt limit may end control this long before apogee, and the roll until then still counts as `held`."},

  {"timing", "pad_time_s", number("s", {1, 600}), may, AT(it.pad_time_s), "From power-up to ignition (tunnel: to the start command), armed or not."},
  {"timing", "arm_time_s", number("s", {0.1, 600}), may, AT(it.arm_time_s), "From power-up to arm switch and self-test, which takes 7 s; earlier than `pad_time_s`."},
  {"timing", "time_after_end_s", number("s", {0, 3600}), may, AT(it.time_after_end_s), "The run goes on this long after apogee (tunnel: after control), and until a parachute opens."},
  {"timing", "log_period_s", number("s", {0.001, 1}), may, AT(it.log_period_s), "Time between the rows of `flight.csv`, in whole milliseconds."},
});
// clang-format on

}  // namespace

std::span<const Field<sim::Scenario>> scenario_fields() { return fields; }

}  // namespace fantail::input
