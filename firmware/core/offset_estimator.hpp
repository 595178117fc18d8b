// SPDX-License-Identifier: MIT
#pragma once

#include "core/disturbance_observer.hpp"
#include "core/flight_plan.hpp"
#include "core/integral_action.hpp"
#include "core/motion_estimator.hpp"
#include "core/pd_controller.hpp"

namespace fantail::core {

/// What the law believes to be the rocket's fin offset u_d, and takes off its command so that the loop rests at its
/// reference: by integral action or by a disturbance observer, as the plan says. Never beyond the plan limit, because
/// what is more no canard can hold against. Only under control does it change, and only from measured rates: it stands
/// still while the gyro is silent or at the end of its range. An observer also does while the speed is too small to
/// tell an offset by, or only known to be at least what it is.
class OffsetEstimator {
 public:
  /// `plan` has passed validate().
  [[gnu::cold]] explicit OffsetEstimator(const FlightPlan& plan);

  /// Zero for a plan that does not reject the offset.
  [[nodiscard]] Angle estimate() const { return estimate_; }

  /// Before the command of a tick. `error` is R - phi, and `gain_factor` that of the gain schedule.
  void update(Microseconds now, const Motion& motion, Angle error, float gain_factor);

  /// What became the command of this tick.
  void remember(const RollCommand& roll) {
    command_ = roll.command;
    taken_off_ = clamp(roll.before_excitation, canard_limit_) - roll.before_excitation;
  }

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(estimate_, last_time_, last_rate_rad_s_, command_, taken_off_);
  }

 private:
  OffsetRejection rejection_;
  Angle canard_limit_;
  IntegralAction integral_;
  DisturbanceObserver observer_;
  Angle estimate_;
  Microseconds last_time_{};  ///< of the last tick with a measured rate
  float last_rate_rad_s_ = 0.0F;
  Angle command_;
  Angle taken_off_;  ///< by the plan limit, of the command before the excitation
};

}  // namespace fantail::core
