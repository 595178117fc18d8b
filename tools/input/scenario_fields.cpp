// SPDX-License-Identifier: MIT
#include "input/scenario_file.hpp"

namespace fantail::input {
namespace {

constexpr std::array<std::string_view, 2> surroundings{"flight", "tunnel"};
constexpr std::array<std::string_view, 3> densities{"exponential", "isa", "constant"};
constexpr std::size_t most_points = 1000;

// The imposed roll is there when its section is.
sim::ImposedRoll& made(std::optional<sim::ImposedRoll>& roll) { return roll ? *roll : roll.emplace(); }
const sim::ImposedRoll& made(const std::optional<sim::ImposedRoll>& roll) { return *roll; }

// clang-format off: one field a row reads better than one argument a line
#define AT(expression) FANTAIL_PLACE(sim::Scenario, expression)
constexpr auto fields = std::to_array<Field<sim::Scenario>>({
  {"", "vehicle", file(), must, AT(it.vehicle_name), "The vehicle that flies."},
  {"", "plan", file(), must, AT(it.plan_name), "The flight plan that its avionics is told."},
  {"", "seed", integer({}, {0, 9e15}), may, AT(it.seed), "Of every random stream."},
  {"", "assumed", list(100, text()), may, AT(grown(it.assumed, i)), "What in this file was assumed and not measured, a sentence each; reports repeat it, and that of the vehicle."},
  {"", "tunnel_result", file(), may, {}, "What `predict` starts from ([Predicting a launch](predict.md)); a flight makes no use of it."},

  {"environment", "surroundings", choice(surroundings), may, AT(it.surroundings), "`tunnel` for plans with `run.start = \"tunnel\"`, and only for them."},
  {"environment", "density", choice(densities), may, AT(it.atmosphere.model), "Air over height: 1.225 kg/m3 exp(-h / 8500 m), the International Standard Atmosphere, or the same everywhere. Not in the tunnel, which has its own."},
  {"environment", "density_kg_m3", number("kg/m3", {0.01, 5}), may, AT(it.atmosphere.constant_kg_m3), "For `constant`, in flight."},
  {"environment", "guide_tilt_deg", number(deg, {0, 15}), may, AT(it.guide_tilt_rad), "Launch guide against the vertical."},
  {"environment", "wind_m_s", number("m/s", {0, 30}), may, AT(it.wind_m_s), "Wind across the launch site. It is not simulated: reports say where it matters."},

  {"tunnel", "fan_rpm", number("rpm", {0, 3000}), may, AT(it.tunnel.fan_rpm), "Fan speed until the first of `fan_times_s`."},
  {"tunnel", "speed_per_rpm_m_s", number("m/s per rpm", {0.001, 0.1}), may, AT(it.tunnel.speed_per_rpm_m_s), "Air speed over fan speed; 0.0176 makes 22 m/s of 1250 rpm."},
  {"tunnel", "turbulence", number("", {0, 0.5}), may, AT(it.tunnel.turbulence), "Standard deviation over mean of the air speed."},
  {"tunnel", "turbulence_time_s", number("s", {0.01, 60}), may, AT(it.tunnel.turbulence_time_s), "Correlation time of the turbulence."},
  {"tunnel", "fan_lag_s", number("s", {0.1, 600}), may, AT(it.tunnel.fan_lag_s), "Time constant with which the air speed follows the fan."},
  {"tunnel", "swirl_deg", number(deg, {-20, 20}), may, AT(it.tunnel.swirl_rad), "Swirl as an equivalent canard angle; added to the disturbance."},
  {"tunnel", "density_kg_m3", number("kg/m3", {0.01, 5}), may, AT(it.tunnel.density_kg_m3), "Density of the air in the tunnel."},
  {"tunnel", "fan_times_s", list(most_points, number("s", {0, 3600})), may, AT(grown(it.fan_programme, i).time_s), "Fan programme: from when on, after the start command; increasing."},
  {"tunnel", "fan_rpms", list(most_points, number("rpm", {0, 3000})), may, AT(grown(it.fan_programme, i).fan_rpm), "Fan programme: which speed; as many as `fan_times_s`."},
  {"tunnel", "wind_sensor_period_s", number("s", {0.001, 600}), may, AT(it.wind_sensor.period_s), "Between two readings in `tunnel.csv`."},
  {"tunnel", "wind_sensor_resolution_m_s", number("m/s", {0, 5}), may, AT(it.wind_sensor.resolution_m_s), "What the readings are rounded to; 0: not at all."},

  {"disturbance", "times_s", list(most_points, number("s", {0, 3600})), may, AT(grown(it.disturbance, i).time_s), "Equivalent fin offset: times of its points after lift-off (tunnel: after control start), increasing."},
  {"disturbance", "angles_deg", list(most_points, number(deg, {-45, 45})), may, AT(grown(it.disturbance, i).angle_rad), "Equivalent fin offset: its angle at each of those times; straight lines between them, constant beyond them."},

  {"imposed_roll", "time_s", number("s", {0, 3600}), must_in_its_section, AT(made(it.imposed_roll).time_s), "When angle and rate are set, once, for a transient that no model explains; after lift-off. The report says so."},
  {"imposed_roll", "angle_deg", number(deg, {-3600, 3600}), must_in_its_section, AT(made(it.imposed_roll).angle_rad), "Roll angle from then on."},
  {"imposed_roll", "rate_deg_s", number(deg_s, {-3600, 3600}), must_in_its_section, AT(made(it.imposed_roll).rate_rad_s), "Roll rate from then on."},

  {"timing", "pad_time_s", number("s", {1, 600}), may, AT(it.pad_time_s), "From power-up to ignition (tunnel: to the start command), whether armed by then or not."},
  {"timing", "arm_time_s", number("s", {0.1, 600}), may, AT(it.arm_time_s), "From power-up to the arm switch and the self-test, which takes about seven seconds; earlier than `pad_time_s`."},
  {"timing", "time_after_end_s", number("s", {0, 3600}), may, AT(it.time_after_end_s), "The run goes on this long after apogee (tunnel: after control)."},
  {"timing", "log_period_s", number("s", {0.001, 1}), may, AT(it.log_period_s), "Between the rows of `flight.csv`; whole milliseconds, more than one for runs of many minutes."},
});
// clang-format on

}  // namespace

std::span<const Field<sim::Scenario>> scenario_fields() { return fields; }

}  // namespace fantail::input
