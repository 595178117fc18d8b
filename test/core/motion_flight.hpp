// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan_fields.hpp"
#include "core/motion_estimator.hpp"
#include "motion_rig.hpp"

namespace fantail::core {

inline MotionPlan plan_with(HeightOrigin origin) {
  MotionPlan plan = default_plan().motion;
  plan.height_origin = origin;
  return plan;
}

/// A rig and the estimator that watches it, 1 kHz.
class Flight {
 public:
  explicit Flight(const MotionRig::Setup& setup = {}, HeightOrigin origin = HeightOrigin::replay)
      : rig{setup}, estimator{plan_with(origin)} {}

  /// A change falls between two samples, half a tick before the first one that shows it: what a trapezoid assumes.
  void run(Microseconds length, double acceleration_m_s2, double roll_rate_rad_s) {
    for (const Microseconds end = rig.time() + length; rig.time() < end;) {
      rig.advance(tick / 2, acceleration_m_s2_, roll_rate_rad_s_);
      acceleration_m_s2_ = acceleration_m_s2;
      roll_rate_rad_s_ = roll_rate_rad_s;
      rig.advance(tick / 2, acceleration_m_s2, roll_rate_rad_s);
      estimator.update(rig.inputs());
    }
  }
  void stand(Microseconds length = Microseconds{4'000'000}) { run(length, 0.0, 0.0); }

  void lift_off(double acceleration_m_s2, double roll_rate_rad_s) { run(tick, acceleration_m_s2, roll_rate_rad_s); }

  [[nodiscard]] Motion motion() const { return estimator.motion(rig.time()); }

  MotionRig rig;
  MotionEstimator estimator;

 private:
  static constexpr Microseconds tick{1'000};

  double acceleration_m_s2_ = 0.0;
  double roll_rate_rad_s_ = 0.0;
};

}  // namespace fantail::core
