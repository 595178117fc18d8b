// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"

namespace fantail::core {

/// A disturbance observer: what turned the rocket and was no canard, as an equivalent fin offset, by the roll model
///
///   p' = -a p + b (u + u_d),   a = rho v A alpha / (2 I),   b = rho v^2 A beta / (2 I)   (Eq 1-3)
///
/// and a first-order low-pass with the plan's bandwidth w:
///
///   d' = w ((p' + a p) / b - u - d)
///
/// The rate's change stands in it and not its derivative, so noise comes in as w / b times the rate: no more than a
/// larger derivative gain would make of it.
class DisturbanceObserver {
 public:
  /// `model` has passed validate() together with a plan that observes, or is not used.
  explicit DisturbanceObserver(const OffsetPlan& plan, const RollModelPlan& model)
      : bandwidth_rad_s_{plan.observer_bandwidth_rad_s},
        damping_m2_{model.damping_m2},
        torque_m_{model.torque_m},
        per_metre3_{0.5F * model.density_kg_m3 * model.reference_area_m2 / model.roll_inertia_kg_m2} {}

  /// The estimate after `elapsed_s` in which `command` stood and the rate went from `before` to `now`; speed above
  /// zero.
  [[nodiscard]] Angle observed(Angle estimate, Angle command, float before_rad_s, float now_rad_s, float speed_m_s,
                               float elapsed_s) const {
    const float common = per_metre3_ * speed_m_s;
    const float turned = (now_rad_s - before_rad_s) + elapsed_s * (common * damping_m2_) * before_rad_s;
    const Angle by_all = Angle::from_radians(turned / (common * speed_m_s * torque_m_));
    return estimate + bandwidth_rad_s_ * (by_all - elapsed_s * (command + estimate));
  }

 private:
  float bandwidth_rad_s_;
  float damping_m2_;
  float torque_m_;
  float per_metre3_;  ///< rho A / (2 I)
};

}  // namespace fantail::core
