// SPDX-License-Identifier: MIT
#include "core/gyro_gate.hpp"

#include <algorithm>
#include <cmath>

#include "core/finite.hpp"

namespace fantail::core {
namespace {

constexpr std::uint32_t agreeing_samples = 5;
// Between two samples: 1000 rad/s2 at 1 kHz, some nine times what canards and fins did to the second published launch.
constexpr float largest_change_rad_s = 1.0F;
// Of the end of the range, what the last rate must have come to.
constexpr float on_its_way = 0.75F;

bool agree(const Vector3& a, const Vector3& b) {
  return is_within({a.x - b.x, a.y - b.y, a.z - b.z}, largest_change_rad_s);
}

}  // namespace

SensorState GyroGate::update(Microseconds now, const GyroSample& sample, bool flies, float roll_rate_rad_s) {
  if (is_usable(now, sample, roll_rate_rad_s)) {
    if (!last_time_ || sample.time > *last_time_) {
      const bool was_silent = last_time_ && sample.time - *last_time_ > stale_time_;
      if (!was_silent || !flies || is_back(sample)) {
        last_time_ = sample.time;
        agreeing_ = 0;
        return SensorState::fresh;
      }
    } else if (sample.time == *last_time_) {
      return SensorState::coasting;  // a repeated time is a sample seen before, not a bad one
    }
  }
  const Microseconds patience = flies ? std::max(stale_time_, longest_gap_) : stale_time_;
  return !last_time_ || now - *last_time_ > patience ? SensorState::failed : SensorState::lost;
}

bool GyroGate::is_usable(Microseconds now, const GyroSample& sample, float roll_rate_rad_s) const {
  if (!is_current(now, sample.time, stale_time_) || !is_within(sample.rate_rad_s, largest_rate_rad_s)) {
    return false;
  }
  if (sample.quality != SampleQuality::saturated) {
    return sample.quality == SampleQuality::valid;
  }
  const float end_rad_s = sample.rate_rad_s.x;
  return std::copysign(1.0F, end_rad_s) * roll_rate_rad_s >= on_its_way * std::abs(end_rad_s);
}

bool GyroGate::is_back(const GyroSample& sample) {
  if (agreeing_ > 0 && sample.time <= returning_time_) {
    return false;
  }
  agreeing_ = agreeing_ > 0 && agree(sample.rate_rad_s, returning_rate_rad_s_) ? agreeing_ + 1 : 1;
  returning_time_ = sample.time;
  returning_rate_rad_s_ = sample.rate_rad_s;
  return agreeing_ >= agreeing_samples;
}

}  // namespace fantail::core
