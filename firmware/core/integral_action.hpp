// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"

namespace fantail::core {

struct IntegralAction {
  float gain_per_s;      ///< ki
  float tracking_per_s;  ///< ki / kp: how fast the estimate follows what the plan limit takes off
};

/// Of no use where the plan has no integral action, and perhaps no kp to divide by.
[[nodiscard]] inline IntegralAction integral_action(const ControllerPlan& controller, const OffsetPlan& offset) {
  return {.gain_per_s = offset.integral_gain_per_s,
          .tracking_per_s = offset.integral_gain_per_s / controller.proportional_gain};
}

/// Integral action, written as an estimate d of the fin offset that the law takes off its command:
///
///   d' = -ki (R - phi) - (ki / kp) (clamp(v) - v)
///
/// v is the command before the excitation. What the plan limit takes off it, clamp(v) - v, pulls the estimate back
/// (back-calculation, with the integral's own time kp / ki), so that it does not wind up while the canards can give no
/// more, and a chirp that meets the limit does not move it. Returns d after `elapsed_s`.
[[nodiscard]] inline Angle integrated(const IntegralAction& action, Angle estimate, Angle error, Angle taken_off,
                                      float elapsed_s) {
  return estimate - (elapsed_s * action.gain_per_s) * error - (elapsed_s * action.tracking_per_s) * taken_off;
}

}  // namespace fantail::core
