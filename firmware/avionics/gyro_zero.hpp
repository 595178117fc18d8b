// SPDX-License-Identifier: MIT
#pragma once

#include "core/inputs.hpp"

namespace fantail::avionics {

/// What a gyro reads while nothing moves, or while the rocket turns evenly: the two look the same. Averaged over the
/// latest stretch of samples that stay within 1 deg/s of their mean.
class GyroZero {
 public:
  /// A sample that was seen before, or has no rate, changes nothing.
  void take(const core::GyroSample& sample);

  /// On some axis, for at least half a second; false beyond 10 deg/s, where somebody turns the rocket.
  [[nodiscard]] bool is_beyond(float rate_rad_s) const;

 private:
  core::Vector3 sum_rad_s_{};
  float samples_ = 0.0F;
  core::Microseconds last_sample_{};
};

}  // namespace fantail::avionics
