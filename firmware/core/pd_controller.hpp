// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite.hpp"
#include "core/flight_plan.hpp"

namespace fantail::core {

struct RollCommand {
  Angle unclamped{};
  Angle command{};  ///< within the plan limit
  bool saturated = false;
  bool finite = true;  ///< false: an input was NaN or infinite, and the command is zero
};

/// u = kp (R - phi) + kd (R' - p) + excitation, clamped to the plan limit (Eq 10, 28-31). The excitation stands inside
/// the sum, so the clamp comes after it. R' is zero, or R itself with `rate_reference = "paper_literal"`: the paper
/// prints kd (R - p), which for a stepped reference can only be a slip, but whoever wants to repeat it to the letter
/// can. A PD loop settles at R + u_d / kp, not at R: that is the published design.
[[nodiscard]] inline RollCommand pd_controller(const ControllerPlan& plan, Angle reference, Angle roll_angle,
                                               float roll_rate_rad_s, Angle excitation) {
  const float rate_reference_rad_s = plan.rate_reference == RateReference::paper_literal ? reference.radians() : 0.0F;
  const Angle proportional = plan.proportional_gain * (reference - roll_angle);
  const Angle derivative = Angle::from_radians(plan.derivative_gain_s * (rate_reference_rad_s - roll_rate_rad_s));
  const Angle unclamped = proportional + derivative + excitation;
  if (!is_finite(unclamped.radians())) {
    return RollCommand{.finite = false};
  }
  const Angle command = clamp(unclamped, plan.canard_limit);
  return RollCommand{.unclamped = unclamped, .command = command, .saturated = command != unclamped};
}

}  // namespace fantail::core
