// SPDX-License-Identifier: MIT
#include "sim/felt_motion.hpp"

#include "sim/rotation.hpp"

namespace fantail::sim {

FeltMotion::FeltMotion(const FeltMotionParameters& parameters)
    : parameters_{parameters}, is_ideal_{parameters == FeltMotionParameters{}} {}

BodyMotion FeltMotion::felt(const BodyMotion& motion, const Shaking& shaking, std::optional<double> centre_of_gravity_m,
                            double time_s) const {
  const FeltMotionParameters& p = parameters_;
  const Vector3 arm_m{.x = p.position_m && centre_of_gravity_m ? *centre_of_gravity_m - *p.position_m : 0.0,
                      .y = p.across_m};
  const Vector3& rate = motion.rate_rad_s;
  BodyMotion felt = motion;
  felt.specific_force_m_s2 = motion.specific_force_m_s2 + cross(motion.angular_acceleration_rad_s2, arm_m) +
                             cross(rate, cross(rate, arm_m)) + shaking.specific_force_m_s2;
  const double drift = p.rate_drift_rad_s2 * time_s;
  felt.rate_rad_s = (1.0 + p.rate_scale_error) * (rate + shaking.rate_rad_s) +
                    p.rate_per_specific_force_s_m * felt.specific_force_m_s2 +
                    Vector3{.x = drift, .y = drift, .z = drift};
  felt.specific_force_m_s2 = (1.0 + p.specific_force_scale_error) * felt.specific_force_m_s2;
  return felt;
}

}  // namespace fantail::sim
