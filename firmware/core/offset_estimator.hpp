// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/disturbance_observer.hpp"
#include "core/finite.hpp"
#include "core/flight_plan.hpp"
#include "core/integral_action.hpp"
#include "core/motion_estimator.hpp"
#include "core/pd_controller.hpp"

namespace fantail::core {

/// What the law believes to be the rocket's fin offset u_d, and takes off its command so that the loop rests at its
/// reference: by integral action or by a disturbance observer, as the plan says. Never beyond the plan limit, because
/// what is more no canard can hold against. Only under control does it change, and only from measured rates: it stands
/// still while the gyro is silent or at the end of its range. An observer also does while the speed is too small to
/// tell an offset by, or only known to be at least what it is. With entry by capture it begins with what the spin
/// before control told, and an integral stands still while the angle's part of the command alone is beyond the plan
/// limit.
class OffsetEstimator {
 public:
  /// `plan` has passed validate().
  [[gnu::cold]] explicit OffsetEstimator(const FlightPlan& plan);

  /// Zero for a plan that does not reject the offset.
  [[nodiscard]] Angle estimate() const { return estimate_; }

  /// Control begins by capture, and this is known of the offset.
  void begin(Angle offset) {
    if (rejection_ != OffsetRejection::none) {
      estimate_ = clamp(offset, canard_limit_);
    }
  }

  /// Before the command of a tick. `error` is R - phi, `gain_factor` that of the gain schedule, and `reach` what the
  /// canards can make of a command. A tick that came late counts as one.
  void update(const Motion& motion, Angle error, float gain_factor, const AngleRange& reach) {
    if (rejection_ == OffsetRejection::none) {
      return;
    }
    // A sample that is only late is not missed: what the rate did meanwhile is seen with it.
    const bool measures = motion.gyro == SensorState::fresh || motion.gyro == SensorState::coasting;
    if (!measures || motion.rate_is_lower_bound) {
      interrupt();
      return;
    }
    Angle estimate = estimate_;
    if (rejection_ == OffsetRejection::integral) {
      // Turning a captured rocket back is no sign of an offset, and would wind the integral up.
      if (captures_ && abs(gain_factor * proportional_gain_ * error) > canard_limit_) {
        return;
      }
      estimate = integral_.integrated(estimate, gain_factor * error);
      const Angle reached = clamp(before_excitation_, reach);
      if (reached != before_excitation_) {
        estimate = integral_.pulled_back(estimate, reached - before_excitation_);
      }
    } else {
      if (last_rate_rad_s_ && motion.speed_m_s >= slowest_observed_m_s && !motion.speed_is_lower_bound) {
        estimate = observer_.observed(estimate, command_, *last_rate_rad_s_, motion.roll_rate_rad_s, motion.speed_m_s);
      }
      last_rate_rad_s_ = motion.roll_rate_rad_s;
    }
    if (abs(estimate) <= canard_limit_) {
      estimate_ = estimate;
    } else if (is_finite(estimate.radians())) {
      estimate_ = clamp(estimate, canard_limit_);
    }
  }

  /// The cause of rotation since the last update is unknown: the next rate cannot be compared with the last.
  void interrupt() { last_rate_rad_s_.reset(); }

  /// What became the command of this tick.
  void remember(const RollCommand& roll) {
    command_ = roll.command;
    before_excitation_ = roll.before_excitation;
  }

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(estimate_, last_rate_rad_s_, command_, before_excitation_);
  }

 private:
  OffsetRejection rejection_;
  bool captures_;
  float proportional_gain_;
  Angle canard_limit_;
  IntegralAction integral_;
  DisturbanceObserver observer_;
  Angle estimate_;
  std::optional<float> last_rate_rad_s_;  ///< of the last tick, for an observer
  Angle command_;
  Angle before_excitation_;
};

}  // namespace fantail::core
