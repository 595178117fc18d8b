// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite.hpp"
#include "core/flight_plan.hpp"

namespace fantail::core {

/// What the law answers: angles of the canards, positive where they roll the rocket positively.
struct RollCommand {
  Angle before_excitation{};  ///< the law's own answer, unclamped
  Angle unclamped{};          ///< with the excitation
  Angle command{};            ///< within the plan limit
  bool saturated = false;     ///< `command` is not `unclamped`
  bool finite = true;         ///< false: an input was NaN or infinite, and the command is zero
};

/// What goes beyond the publication; as it stands here, nothing does.
struct Adaptation {
  float gain_factor = 1.0F;  ///< on both gains, see gain_schedule.hpp
  Angle offset_estimate{};   ///< of u_d, see offset_estimator.hpp
};

/// u = kp (R - phi) + kd (R' - p) - d + excitation, clamped to the plan limit (Eq 10, 28-31). The excitation stands
/// inside the sum, so the clamp comes after it. R' is zero, or R itself with `rate_reference = "paper_literal"`: the
/// paper prints kd (R - p), which for a stepped reference can only be a slip, but whoever wants to repeat it to the
/// letter can. d is an estimate of the offset; as published there is none, and the loop settles at R + u_d / kp, not at
/// R.
[[nodiscard]] inline RollCommand pd_controller(const ControllerPlan& plan, Angle reference, Angle roll_angle,
                                               float roll_rate_rad_s, Angle excitation,
                                               const Adaptation& adaptation = {}) {
  const float rate_reference_rad_s = plan.rate_reference == RateReference::paper_literal ? reference.radians() : 0.0F;
  const float proportional_gain = adaptation.gain_factor * plan.proportional_gain;
  const float derivative_gain_s = adaptation.gain_factor * plan.derivative_gain_s;
  const Angle proportional = proportional_gain * (reference - roll_angle);
  const Angle derivative = Angle::from_radians(derivative_gain_s * (rate_reference_rad_s - roll_rate_rad_s));
  const Angle before_excitation = proportional + derivative - adaptation.offset_estimate;
  const Angle unclamped = before_excitation + excitation;
  if (!is_finite(unclamped.radians())) {
    return RollCommand{.finite = false};
  }
  const Angle command = clamp(unclamped, plan.canard_limit);
  return RollCommand{.before_excitation = before_excitation,
                     .unclamped = unclamped,
                     .command = command,
                     .saturated = command != unclamped};
}

}  // namespace fantail::core
