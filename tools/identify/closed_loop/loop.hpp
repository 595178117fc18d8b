// SPDX-License-Identifier: MIT
#pragma once

#include "core/pd_controller.hpp"
#include "identify/model/roll_equation.hpp"

// The loop as a control engineer draws it. Over one sub-step, in this order, for one candidate:
//
//   law     command = law(reference - phi, p)
//   servo   mean = servo.mean(canard, command),    canard = servo.end(canard, command)
//   plant   x = beta (mean + disturbance),         phi += plant.angle_change(p, x),    p = plant.rate_after(p, x)
//
// Servo and plant are linear, so what updates the state updates its derivative by an unknown, too. lanes.hpp does all
// this for several candidates side by side.

namespace fantail::identify::closed_loop {

/// How the canards were commanded.
struct Control {
  core::ControllerPlan controller{};
  double servo_lag_s = 0.0;            ///< first-order, between command and canard; 0: none, as published
  double controller_period_s = 0.001;  ///< the law runs as often, whatever the log's rate
};

/// Law: the flight controller's own code,
///   command = clamp(kp (R - phi) + kd (R' - p) + chirp),
/// and its slopes by angle and rate: zero at a limit, where the command depends on neither.
struct Command {
  double command_rad;
  double by_angle;
  double by_rate_s;
};

[[nodiscard]] inline Command law(const core::ControllerPlan& plan, core::Angle reference, core::Angle excitation,
                                 double angle_rad, double rate_rad_s) {
  const core::RollCommand command =
      core::pd_controller(plan, reference, core::Angle::from_radians(static_cast<float>(angle_rad)),
                          static_cast<float>(rate_rad_s), excitation);
  const bool free = command.finite && !command.saturated;
  return {.command_rad = static_cast<double>(command.command.radians()),
          .by_angle = free ? -static_cast<double>(plan.proportional_gain) : 0.0,
          .by_rate_s = free ? -static_cast<double>(plan.derivative_gain_s) : 0.0};
}

/// Servo: the canard follows the command,
///   lag dcanard/dt = command - canard,
/// while the command holds over the sub-step.
struct Servo {
  double decay;       ///< how much of the distance to the command is left at the end; 0 without a lag
  double mean_share;  ///< and on average

  [[nodiscard]] double mean(double canard, double command) const { return command + mean_share * (canard - command); }
  [[nodiscard]] double end(double canard, double command) const { return command + decay * (canard - command); }
};

/// Plant: model::HeldStep, the exact step of the roll equation. Where the canard is the command and the command is new,
/// law and plant together are one matrix: how angle and rate after the sub-step change with those before it.
struct DirectLoop {
  double angle_by_angle;
  double angle_by_rate_s;
  double rate_by_angle;
  double rate_by_rate;
};

[[nodiscard]] inline DirectLoop direct_loop(const model::HeldStep& plant, double beta_m, double command_by_angle,
                                            double command_by_rate_s) {
  const double by_angle = beta_m * command_by_angle;
  const double by_rate = beta_m * command_by_rate_s;
  return {.angle_by_angle = 1.0 + plant.angle_gain * by_angle,
          .angle_by_rate_s = plant.angle_p_s + plant.angle_gain * by_rate,
          .rate_by_angle = plant.rate_gain * by_angle,
          .rate_by_rate = plant.decay + plant.rate_gain * by_rate};
}

}  // namespace fantail::identify::closed_loop
