// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/flight_plan.hpp"
#include "sim/disturbance.hpp"
#include "sim/roll_plant.hpp"

namespace fantail::paper {

// The published closed loop and nothing else: the product's plant, controller, reference and chirp, joined by a servo
// that is a pure first-order lag, at a density of 1.2 kg/m3 throughout. No sensors, no mixer, no phases. The
// modes of the law beyond the publication are there for whoever asks for them.

inline constexpr double radians_per_degree = 0.017453292519943295;
inline constexpr double density_kg_m3 = 1.2;
inline constexpr double reference_area_m2 = 5.0265e-5;

struct Loop {
  sim::RollPlant plant{};
  core::ControllerPlan controller{};
  core::ReferencePlan reference{};
  core::ExcitationPlan excitation{};
  sim::Disturbance disturbance{};
  std::function<double(double time_s)> speed_m_s;
  double control_from_s = 0.0;
  std::optional<double> servo_lag_s{};  ///< empty: ideal
  double servo_play_rad = 0.0;          ///< whole width, behind a lag only
  sim::RollState start{};
  core::GainSchedulePlan gain_schedule{};
  core::OffsetPlan offset{};  ///< with the controller's gains
  core::RollModelPlan roll_model{};
  std::vector<sim::RollState> measured_off{};  ///< by how much at each tick, for law and log; empty: not at all
};

struct Point {
  double time_s;
  double angle_deg;  ///< as measured, and so the rate
  double rate_deg_s;
  double command_deg;
  double canard_deg;  ///< as an encoder sees it
  bool saturated;
  double offset_estimate_deg;
};

/// One point a millisecond, from 0 to `until_s`.
[[nodiscard]] std::vector<Point> run(const Loop& loop, double until_s);

/// The point nearest to a time.
[[nodiscard]] const Point& at(const std::vector<Point>& points, double time_s);

[[nodiscard]] const Point& peak(const std::vector<Point>& points, double from_s, double to_s);
[[nodiscard]] const Point& trough(const std::vector<Point>& points, double from_s, double to_s);
[[nodiscard]] double mean_angle_deg(const std::vector<Point>& points, double from_s, double to_s);
[[nodiscard]] double saturated_share(const std::vector<Point>& points, double from_s, double to_s);

/// A plan's controller with these gains; a limit of 90 degrees is no limit.
[[nodiscard]] core::ControllerPlan gains(double proportional, double derivative_s, double limit_deg);
[[nodiscard]] core::ReferencePlan hold(double angle_deg);
[[nodiscard]] core::ReferencePlan step(double from_deg, double to_deg, double time_s);

/// Speed of the shipped launches: the ascent with the canonical motor and the exponential density.
[[nodiscard]] std::function<double(double)> launch_speed(double mass_kg, double from_liftoff_s);

}  // namespace fantail::paper
