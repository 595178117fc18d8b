// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "core/pd_controller.hpp"
#include "identify/model/roll_equation.hpp"

// The loop as a control engineer draws it. Over one sub-step, in this order, for one candidate:
//
//   law     command = law(reference - phi, p, estimate of the offset as logged)
//   servo   gear = servo.end(gear, command), and its mean;    play: the canard follows within half of it
//   plant   x = beta (mean + disturbance),         phi += plant.angle_change(p, x),    p = plant.rate_after(p, x)
//
// Servo and plant are linear, so what updates the state updates its derivative by an unknown, too; within the play the
// canard stands, and so does its derivative. lanes.hpp does all
// this for several candidates side by side.

namespace fantail::identify::closed_loop {

/// How the canards were commanded.
struct Control {
  core::ControllerPlan controller{};
  core::GainSchedulePlan gain_schedule{};
  core::OffsetRejection offset_rejection = core::OffsetRejection::none;
  double servo_lag_s = 0.0;            ///< first-order, between command and canard; 0: none, as published
  double servo_play_rad = 0.0;         ///< whole width, between gear and canard
  bool servo_is_fitted = false;        ///< with the model: the two above are where to begin, later what was found
  double controller_period_s = 0.001;  ///< the law runs as often, whatever the log's rate
};

/// Law: the flight controller's own code,
///   command = clamp(f kp (R - phi) + f kd (R' - p) - d + chirp),
/// and its slopes by angle and rate: zero at a limit, where the command depends on neither. f is the factor of the gain
/// schedule. d is the offset estimate of the law that flew: what it subtracted from its command is known to the bit,
/// so it drives the loop as reference and chirp do, and does not depend on the model.
struct Command {
  double command_rad;
  double by_angle;
  double by_rate_s;
};

[[nodiscard]] inline Command law(const core::ControllerPlan& plan, core::Angle reference, core::Angle excitation,
                                 const core::Adaptation& adaptation, double angle_rad, double rate_rad_s) {
  const core::RollCommand command =
      core::pd_controller(plan, reference, core::Angle::from_radians(static_cast<float>(angle_rad)),
                          static_cast<float>(rate_rad_s), excitation, adaptation);
  const double slope = command.finite && !command.saturated ? -static_cast<double>(adaptation.gain_factor) : 0.0;
  return {.command_rad = static_cast<double>(command.command.radians()),
          .by_angle = slope * static_cast<double>(plan.proportional_gain),
          .by_rate_s = slope * static_cast<double>(plan.derivative_gain_s)};
}

/// Servo: the gear follows the command,
///   lag dgear/dt = command - gear,
/// while the command holds over the sub-step.
struct Servo {
  double decay;           ///< how much of the distance to the command is left at the end; 0 without a lag
  double mean_share;      ///< and on average
  double decay_by_lag_s;  ///< derivatives
  double mean_by_lag_s;

  [[nodiscard]] double mean(double gear, double command) const { return command + mean_share * (gear - command); }
  [[nodiscard]] double end(double gear, double command) const { return command + decay * (gear - command); }
};

[[nodiscard]] inline Servo servo_of(double lag_s, double duration_s) {
  if (duration_s == 0.0) {
    return {.decay = 1.0, .mean_share = 1.0, .decay_by_lag_s = 0.0, .mean_by_lag_s = 0.0};
  }
  const double lags = duration_s / lag_s;
  const double decay = std::exp(-lags);
  return {.decay = decay,
          .mean_share = -std::expm1(-lags) / lags,
          .decay_by_lag_s = decay * lags / lag_s,
          .mean_by_lag_s = (1.0 - decay * (1.0 + lags)) / duration_s};
}

/// The gear is where it was commanded.
inline constexpr Servo no_servo{.decay = 0.0, .mean_share = 0.0, .decay_by_lag_s = 0.0, .mean_by_lag_s = 0.0};

/// Play: the canard stays where it is until the gear takes it along, half of the play away on the one side or the
/// other.
struct Played {
  double canard_rad;
  double side;  ///< of the gear that it lies on: -1, 1; 0 while it stays
};

[[nodiscard]] inline Played follow(double canard_rad, double gear_rad, double half_play_rad) {
  if (canard_rad < gear_rad - half_play_rad) {
    return {.canard_rad = gear_rad - half_play_rad, .side = -1.0};
  }
  if (canard_rad > gear_rad + half_play_rad) {
    return {.canard_rad = gear_rad + half_play_rad, .side = 1.0};
  }
  return {.canard_rad = canard_rad, .side = 0.0};
}

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
