// SPDX-License-Identifier: MIT
#include "avionics/gyro_zero.hpp"

#include "core/angle.hpp"
#include "core/finite.hpp"

namespace fantail::avionics {
namespace {

constexpr float steady_within_rad_s = core::Angle::from_degrees(1.0F).radians();
constexpr float largest_zero_rad_s = core::Angle::from_degrees(10.0F).radians();
constexpr float least_samples = 500.0F;

}  // namespace

void GyroZero::take(const core::GyroSample& sample) {
  const core::Vector3& rate = sample.rate_rad_s;
  if (sample.quality != core::SampleQuality::valid || sample.time == last_sample_ ||
      !core::is_within(rate, core::largest_rate_rad_s)) {
    return;
  }
  last_sample_ = sample.time;
  const float n = samples_;
  const core::Vector3 off{n * rate.x - sum_rad_s_.x, n * rate.y - sum_rad_s_.y, n * rate.z - sum_rad_s_.z};
  if (!core::is_within(off, n * steady_within_rad_s)) {
    sum_rad_s_ = {};
    samples_ = 0.0F;
  }
  sum_rad_s_ = {sum_rad_s_.x + rate.x, sum_rad_s_.y + rate.y, sum_rad_s_.z + rate.z};
  samples_ += 1.0F;
}

bool GyroZero::is_beyond(float rate_rad_s) const {
  return samples_ >= least_samples && !core::is_within(sum_rad_s_, samples_ * rate_rad_s) &&
         core::is_within(sum_rad_s_, samples_ * largest_zero_rad_s);
}

}  // namespace fantail::avionics
