// SPDX-License-Identifier: MIT
#include "paper/closed_loop.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/chirp.hpp"
#include "core/flight_plan_fields.hpp"
#include "core/gain_schedule.hpp"
#include "core/offset_estimator.hpp"
#include "core/pd_controller.hpp"
#include "core/roll_reference.hpp"
#include "paper/flown_ascent.hpp"

namespace fantail::paper {
namespace {

constexpr double tick_s = 1e-3;

core::Angle degrees(double value) { return core::Angle::from_degrees(static_cast<float>(value)); }

auto between(const std::vector<Point>& points, double from_s, double to_s) {
  const auto first = std::ranges::lower_bound(points, from_s - 1e-9, {}, &Point::time_s);
  const auto last = std::ranges::upper_bound(points, to_s + 1e-9, {}, &Point::time_s);
  return std::ranges::subrange{first, last};
}

core::FlightPlan plan_of(const Loop& loop) {
  core::FlightPlan plan = core::default_plan();
  plan.controller = loop.controller;
  plan.offset = loop.offset;
  plan.roll_model = loop.roll_model;
  return plan;
}

core::Motion measured(const sim::RollState& state, double speed_m_s) {
  core::Motion motion;
  motion.roll_angle = core::Angle::from_radians(static_cast<float>(state.angle_rad));
  motion.roll_rate_rad_s = static_cast<float>(state.rate_rad_s);
  motion.speed_m_s = static_cast<float>(speed_m_s);
  motion.gyro = core::SensorState::fresh;
  return motion;
}

}  // namespace

std::vector<Point> run(const Loop& loop, double until_s) {
  std::vector<Point> points;
  core::Chirp chirp{loop.excitation};
  core::OffsetEstimator estimator{plan_of(loop)};
  sim::RollState state = loop.start;
  double gear_rad = 0.0;
  double canard_rad = 0.0;
  const auto ticks = static_cast<int>(std::lround(until_s / tick_s));
  const auto control_from = static_cast<int>(std::lround(loop.control_from_s / tick_s));
  for (int tick = 0; tick <= ticks; ++tick) {
    const double t = tick * tick_s;
    const sim::RollState off = loop.measured_off.empty() ? sim::RollState{} : loop.measured_off[points.size()];
    const sim::RollState shown{.angle_rad = state.angle_rad + off.angle_rad,
                               .rate_rad_s = state.rate_rad_s + off.rate_rad_s};
    core::RollCommand command;
    if (tick >= control_from) {
      const core::Microseconds since{(tick - control_from) * 1000};
      const core::Motion motion = measured(shown, loop.speed_m_s(t));
      const core::Angle reference = core::roll_reference(loop.reference, since);
      const float factor = core::gain_factor(loop.gain_schedule, motion.speed_m_s, false);
      estimator.update(motion, reference - motion.roll_angle, factor,
                       {-loop.controller.canard_limit, loop.controller.canard_limit});
      command = core::pd_controller(loop.controller, reference, motion.roll_angle, motion.roll_rate_rad_s,
                                    chirp.update(since), {factor, estimator.estimate()});
      estimator.remember(command);
    }
    const auto goal_rad = static_cast<double>(command.command.radians());
    points.push_back({.time_s = t,
                      .angle_deg = shown.angle_rad / radians_per_degree,
                      .rate_deg_s = shown.rate_rad_s / radians_per_degree,
                      .command_deg = static_cast<double>(command.command.degrees()),
                      .canard_deg = (loop.servo_lag_s ? canard_rad : goal_rad) / radians_per_degree,
                      .saturated = command.saturated,
                      .offset_estimate_deg = static_cast<double>(estimator.estimate().degrees())});

    double seen_rad = goal_rad;  // mean over the step
    if (loop.servo_lag_s) {
      const double decay = std::exp(-tick_s / *loop.servo_lag_s);
      const double apart_rad = gear_rad - goal_rad;
      gear_rad = goal_rad + apart_rad * decay;
      if (loop.servo_play_rad > 0.0) {
        const double before_rad = canard_rad;
        canard_rad = std::clamp(canard_rad, gear_rad - 0.5 * loop.servo_play_rad, gear_rad + 0.5 * loop.servo_play_rad);
        seen_rad = 0.5 * (before_rad + canard_rad);
      } else {
        seen_rad = goal_rad + apart_rad * (*loop.servo_lag_s / tick_s) * (1.0 - decay);
        canard_rad = gear_rad;
      }
    }
    const double middle_s = t + 0.5 * tick_s;
    state = loop.plant.step(state, density_kg_m3, loop.speed_m_s(middle_s), seen_rad + loop.disturbance.at(middle_s),
                            tick_s);
  }
  return points;
}

const Point& at(const std::vector<Point>& points, double time_s) {
  return points[static_cast<std::size_t>(std::lround(time_s / tick_s))];
}

const Point& peak(const std::vector<Point>& points, double from_s, double to_s) {
  return *std::ranges::max_element(between(points, from_s, to_s), {}, &Point::angle_deg);
}

const Point& trough(const std::vector<Point>& points, double from_s, double to_s) {
  return *std::ranges::min_element(between(points, from_s, to_s), {}, &Point::angle_deg);
}

double mean_angle_deg(const std::vector<Point>& points, double from_s, double to_s) {
  double sum = 0.0;
  int count = 0;
  for (const Point& point : between(points, from_s, to_s)) {
    sum += point.angle_deg;
    ++count;
  }
  return sum / count;
}

double saturated_share(const std::vector<Point>& points, double from_s, double to_s) {
  const auto range = between(points, from_s, to_s);
  return static_cast<double>(std::ranges::count_if(range, &Point::saturated)) / static_cast<double>(range.size());
}

core::ControllerPlan gains(double proportional, double derivative_s, double limit_deg) {
  return {.proportional_gain = static_cast<float>(proportional),
          .derivative_gain_s = static_cast<float>(derivative_s),
          .rate_reference = core::RateReference::zero,
          .canard_limit = degrees(limit_deg),
          .entry = core::ControlEntry::as_published};
}

core::ReferencePlan hold(double angle_deg) {
  core::ReferencePlan plan = core::default_plan().reference;
  plan.kind = core::ReferenceKind::hold;
  plan.initial = degrees(angle_deg);
  return plan;
}

core::ReferencePlan step(double from_deg, double to_deg, double time_s) {
  core::ReferencePlan plan = hold(from_deg);
  plan.kind = core::ReferenceKind::steps;
  plan.step_times_count = 1;
  plan.step_times[0] = core::from_seconds(static_cast<float>(time_s));
  plan.step_angles_count = 1;
  plan.step_angles[0] = degrees(to_deg);
  return plan;
}

std::function<double(double)> launch_speed(double mass_kg, double from_liftoff_s) {
  return [flown = std::make_shared<FlownAscent>(mass_kg), from_liftoff_s](double time_s) {
    return flown->speed_m_s(time_s + from_liftoff_s);
  };
}

}  // namespace fantail::paper
