// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite.hpp"
#include "core/flight_plan.hpp"
#include "proof.hpp"

namespace fantail::core {

struct RollCommand {
  Angle before_excitation{};
  Angle unclamped{};
  Angle command{};
  bool saturated = false;
  bool finite = true;
};

struct Adaptation {
  float gain_factor = 1.0F;
  Angle offset_estimate{};
};

/// In the place of the control law: any command that keeps what pd_controller.cpp proves of it.
[[nodiscard]] inline RollCommand pd_controller(const ControllerPlan& plan, Angle, Angle, float, Angle,
                                               const Adaptation& = {}) {
  RollCommand roll{};
  roll.before_excitation = proof::any_angle();
  roll.unclamped = proof::any_angle();
  roll.command = proof::any_angle();
  roll.saturated = nondet_bool();
  roll.finite = nondet_bool();
  proof::assume(abs(roll.command) <= plan.canard_limit && (roll.finite || roll.command == Angle{}));
  return roll;
}

}  // namespace fantail::core
