// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"
#include "core/time.hpp"

namespace fantail::core {

/// Slower, and the air tells less of an offset than a gyro makes noise.
inline constexpr float slowest_observed_m_s = 10.0F;

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
      : share_{seconds(tick_period) * plan.observer_bandwidth_rad_s},
        damping_per_torque_m_{model.damping_m2 / model.torque_m},
        turned_m2_s2_{plan.observer_bandwidth_rad_s * 2.0F * model.roll_inertia_kg_m2 /
                      (model.density_kg_m3 * model.reference_area_m2 * model.torque_m)} {}

  /// The estimate after a tick in which `command` stood and the rate went from `before` to `now`; speed above zero.
  [[nodiscard]] Angle observed(Angle estimate, Angle command, float before_rad_s, float now_rad_s,
                               float speed_m_s) const {
    const float slowness_s_m = 1.0F / speed_m_s;
    const Angle damped = Angle::from_radians(damping_per_torque_m_ * slowness_s_m * before_rad_s);
    const Angle turned = Angle::from_radians(turned_m2_s2_ * slowness_s_m * slowness_s_m * (now_rad_s - before_rad_s));
    return estimate + turned + share_ * (damped - command - estimate);
  }

 private:
  float share_;                 ///< w of a tick
  float damping_per_torque_m_;  ///< alpha / beta: a / b times the speed
  float turned_m2_s2_;          ///< w 2 I / (rho A beta): w / b times the speed squared
};

}  // namespace fantail::core
