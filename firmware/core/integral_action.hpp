// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"
#include "core/time.hpp"

namespace fantail::core {

/// Integral action, written as an estimate d of the fin offset that the law takes off its command:
///
///   d' = -ki (R - phi) - (ki / kp) (clamp(v) - v)
///
/// v is the command before the excitation. What the plan limit takes off it, clamp(v) - v, pulls the estimate back
/// (back-calculation, with the integral's own time kp / ki), so that it does not wind up while the canards can give no
/// more, and a chirp that meets the limit does not move it.
class IntegralAction {
 public:
  /// Of no use where the plan has no integral action, and perhaps no kp to divide by.
  IntegralAction(const ControllerPlan& controller, const OffsetPlan& offset)
      : gain_{seconds(tick_period) * offset.integral_gain_per_s}, tracking_{gain_ / controller.proportional_gain} {}

  /// The estimate after a tick with an error of R - phi.
  [[nodiscard]] Angle integrated(Angle estimate, Angle error) const { return estimate - gain_ * error; }
  /// And after one in which the plan limit took something off.
  [[nodiscard]] Angle pulled_back(Angle estimate, Angle taken_off) const { return estimate - tracking_ * taken_off; }

 private:
  float gain_;      ///< ki of a tick
  float tracking_;  ///< ki / kp of a tick
};

}  // namespace fantail::core
