// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "core/capture.hpp"
#include "core/flight_plan_fields.hpp"
#include "core/offset_estimator.hpp"
#include "core/pd_controller.hpp"
#include "dormancy/capture_forecast.hpp"
#include "dormancy/entry.hpp"
#include "dormancy/opening.hpp"
#include "random_stream.hpp"
#include "sim/servo.hpp"
#include "sim/units.hpp"
#include "text/degrees.hpp"

namespace fantail::dormancy {

/// A rocket whose canards wait, and the plan that then captures it.
struct WaitingRocket {
  RollAtEntry entry{};  ///< rate and angle are those before the wait
  core::OffsetRejection rejection = core::OffsetRejection::none;
  bool has_model = true;
  double wait_s = 1.0;
};

struct FlownCapture {
  RollAtEntry entry{};  ///< as control began, with the share that the law chose by and all dead time
  std::optional<double> captured_after_s{};
};

inline core::FlightPlan plan_of(const WaitingRocket& rocket) {
  const RollAtEntry& e = rocket.entry;
  core::FlightPlan plan = core::default_plan();
  plan.controller.entry = core::ControlEntry::capture;
  plan.controller.proportional_gain = static_cast<float>(e.proportional_gain);
  plan.controller.derivative_gain_s = static_cast<float>(e.derivative_gain_s);
  plan.controller.canard_limit = core::Angle::from_radians(static_cast<float>(e.limit_rad));
  plan.offset.rejection = rocket.rejection;
  plan.offset.integral_gain_per_s = static_cast<float>(e.integral_gain_per_s);
  plan.offset.observer_bandwidth_rad_s =
      e.observer_bandwidth_rad_s > 0.0 ? static_cast<float>(e.observer_bandwidth_rad_s) : 6.0F;
  plan.roll_model = {};
  if (rocket.has_model) {
    plan.roll_model = {.roll_inertia_kg_m2 = static_cast<float>(e.plant.inertia_kg_m2),
                       .reference_area_m2 = static_cast<float>(e.plant.reference_area_m2),
                       .damping_m2 = static_cast<float>(e.plant.damping_m2),
                       .torque_m = static_cast<float>(e.plant.torque_m),
                       .density_kg_m3 = static_cast<float>(e.density_kg_m3)};
  }
  return plan;
}

/// Through the parts of the flight law and a servo, at 1 kHz, until the air is too slow. The reference is zero. Before
/// the gate the speed stays, afterwards the rocket coasts straight up.
inline FlownCapture fly_capture(const WaitingRocket& rocket) {
  constexpr double tick_s = 1e-3;
  const core::FlightPlan plan = plan_of(rocket);
  RollAtEntry e = rocket.entry;
  core::Capture capture{plan};
  core::OffsetEstimator estimator{plan};
  sim::Servo servo{{.lag_s = e.servo_lag_s, .delay_s = e.delay_s, .backlash_rad = 0.0}};
  sim::RollState roll{.angle_rad = e.ahead_rad, .rate_rad_s = e.rate_rad_s};
  double speed_m_s = e.speed_m_s;
  core::Motion motion;
  motion.gyro = core::SensorState::fresh;
  const auto measure = [&] {
    motion.roll_angle = core::Angle::from_radians(static_cast<float>(roll.angle_rad));
    motion.roll_rate_rad_s = static_cast<float>(roll.rate_rad_s);
    motion.speed_m_s = static_cast<float>(speed_m_s);
  };
  double pulse_us = 1500.0;
  double time_s = 0.0;
  const auto advance = [&] {
    servo.step(time_s, tick_s, pulse_us);
    roll = e.plant.step(roll, e.density_kg_m3, speed_m_s, servo.mean_angle_rad() + e.offset_rad, tick_s);
    time_s += tick_s;
  };
  for (int i = 0; i < std::lround(rocket.wait_s / tick_s); ++i) {
    measure();
    capture.watch(motion);
    advance();
  }
  measure();
  const core::Angle turns = capture.begin(motion, core::Angle{});
  if (capture.offset()) {
    estimator.begin(*capture.offset());
  }
  e.ahead_rad = roll.angle_rad;
  e.rate_rad_s = roll.rate_rad_s;
  const double share = capture.offset() ? static_cast<double>(capture.offset()->radians()) / e.limit_rad
                                        : std::copysign(0.5, e.rate_rad_s);
  e.has_model = rocket.has_model;
  if (!rocket.has_model || rocket.wait_s >= offset_known_after_s) {
    e.share = std::min(0.9, std::max(-0.9, share));
  }
  // On average a pulse waits half a frame, and is held for half a tick.
  e.delay_s += 0.5 * sim::ServoParameters{}.frame_period_s + 0.5 * tick_s;
  FlownCapture flown{.entry = e};
  const double reference_rad = static_cast<double>(turns.radians());
  const double rest_rad = reference_rad + (e.rejects_offset() ? 0.0 : e.offset_rad / e.proportional_gain);
  const double begin_s = time_s;
  const double k = 0.5 * e.density_kg_m3 * e.drag_per_mass_m2_kg;
  std::optional<double> since_s;
  while (speed_m_s >= slowest_held_m_s) {
    measure();
    estimator.update(motion, turns - motion.roll_angle, 1.0F,
                     {-plan.controller.canard_limit, plan.controller.canard_limit});
    const core::RollCommand command = pd_controller(plan.controller, turns, motion.roll_angle, motion.roll_rate_rad_s,
                                                    core::Angle{}, {1.0F, estimator.estimate()});
    estimator.remember(command);
    pulse_us = 1500.0 + 10.0 * static_cast<double>(command.command.degrees());
    advance();
    speed_m_s -= tick_s * (sim::gravity_m_s2 + k * speed_m_s * speed_m_s);
    const bool within = std::abs(roll.angle_rad - rest_rad) <= captured_rad;
    since_s = !within ? std::nullopt : since_s ? since_s : std::optional{time_s};
  }
  if (since_s && time_s - *since_s >= shortest_capture_s) {
    flown.captured_after_s = *since_s - begin_s;
  }
  return flown;
}

}  // namespace fantail::dormancy
