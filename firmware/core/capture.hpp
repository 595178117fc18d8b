// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/disturbance_observer.hpp"
#include "core/flight_plan.hpp"
#include "core/motion_estimator.hpp"

namespace fantail::core {

/// With which whole turn the law begins. While the canards stand at trim a rocket turns on, and a law that was given
/// the reference alone would unwind every degree of it. One whole number n, chosen when control begins, goes on the
/// reference as n turns for the rest of the flight. The nearest angle is not the soonest one: full canards turn the
/// rocket faster with its fin offset than against it. Without canards, at this speed, it would come to rest at
/// phi + p / (c v) but for the offset; canards at the limit L then turn it, for each metre flown, by
/// (beta / alpha) (L + |u_d|) one way and (L - |u_d|) the other, so that the two ways take as long where
///
///   n = round((phi + p / (c v) + pi f - R) / (2 pi)),   f = u_d / L within +-0.9,   c = rho A alpha / (2 I)
///
/// u_d is what a disturbance observer, run with a command of zero while the canards waited, found: a spin that the
/// offset did not cause does not deceive it. Without such a wait u_d is what would keep the spin up,
/// alpha p / (beta v) (Eq 27). Without a roll model 1 / (c v) is kd / kp and f a half, in the sense of the spin.
class Capture {
 public:
  /// `plan` has passed validate(), and asks for it.
  [[gnu::cold]] explicit Capture(const FlightPlan& plan);

  /// In every tick in which the canards wait, beyond the guide.
  void watch(const Motion& motion);

  /// The cause of rotation since the last tick is unknown: the next rate cannot be compared with the last.
  void interrupt() { last_rate_rad_s_.reset(); }

  /// Control begins, with this reference: n turns.
  [[nodiscard]] Angle begin(const Motion& motion, Angle reference);

  /// Of the fin offset, at begin(); empty where no model tells.
  [[nodiscard]] const std::optional<Angle>& offset() const { return offset_; }

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(offset_, last_rate_rad_s_);
  }

 private:
  [[nodiscard]] bool tells_offset(const Motion& motion) const;
  [[nodiscard]] Angle kept_up_by(const Motion& motion) const;

  bool has_model_;
  Angle canard_limit_;
  float stop_without_model_s_;  ///< kd / kp
  float stop_distance_m_;       ///< 1 / c
  float damping_per_torque_m_;  ///< alpha / beta
  DisturbanceObserver observer_;
  std::optional<Angle> offset_;
  std::optional<float> last_rate_rad_s_;  ///< of the last tick that measured
};

}  // namespace fantail::core
