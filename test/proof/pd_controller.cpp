// SPDX-License-Identifier: MIT
// Whatever its inputs are, not-a-number and infinities included, the control law's command is a number within the plan
// limit; it is zero where an input made no number; and it says that it is saturated exactly when the limit took
// something off. Any plan limit from 0 to 20 degrees, any gains.
#include "core/pd_controller.hpp"

#include "proof.hpp"

using namespace fantail;
using namespace fantail::core;
using namespace fantail::proof;

int main() {
  ControllerPlan plan{};
  plan.proportional_gain = nondet_float();
  plan.derivative_gain_s = nondet_float();
  plan.rate_reference = any_of<RateReference>(2);
  plan.canard_limit = any_angle();
  assume(plan.canard_limit >= Angle{} && plan.canard_limit <= hard_canard_limit);

  const Adaptation adaptation{.gain_factor = nondet_float(), .offset_estimate = any_angle()};
  const RollCommand roll = pd_controller(plan, any_angle(), any_angle(), nondet_float(), any_angle(), adaptation);

  CLAIM(abs(roll.command) <= plan.canard_limit);
  CLAIM(roll.finite || roll.command == Angle{});
  CLAIM(!roll.finite || is_finite(roll.unclamped.radians()));
  CLAIM(!roll.finite || roll.saturated == (roll.command != roll.unclamped));
  CLAIM(!roll.finite || roll.saturated || roll.command == roll.unclamped);

  REACHABLE(1, roll.finite && roll.saturated);
  REACHABLE(2, roll.finite && !roll.saturated);
  REACHABLE(3, !roll.finite);
  return 0;
}
