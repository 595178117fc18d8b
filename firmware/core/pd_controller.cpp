// SPDX-License-Identifier: MIT
#include "core/pd_controller.hpp"

#include "core/finite.hpp"

namespace fantail::core {

RollCommand pd_controller(const ControllerPlan& plan, Angle reference, Angle roll_angle, float roll_rate_rad_s,
                          Angle excitation) {
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
