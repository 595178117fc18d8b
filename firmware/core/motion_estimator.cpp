// SPDX-License-Identifier: MIT
#include "core/motion_estimator.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "core/finite.hpp"
#include "core/trig.hpp"

namespace fantail::core {
namespace {

using Eigen::Quaternionf;
using Eigen::Vector3f;

// Below this the motor does not push: far enough above 1 g for wind and handling, far below every detection threshold.
constexpr float thrust_threshold_m_s2 = 1.2F * standard_gravity_m_s2;

// The longest allowed hold (0.5 s) and the time a motor may take from 1.2 g to the threshold. Someone who carries the
// rocket about must not collect height for longer than that.
constexpr Microseconds longest_window{600'000};

Vector3f eigen(const Vector3& v) { return {v.x, v.y, v.z}; }
Vector3 plain(const Vector3f& v) { return {v.x(), v.y(), v.z()}; }

Vector3 minus(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

// The rotation of a small vector angle: half-angle sine and cosine by their series, exact to the fourth order.
Quaternionf small_rotation(const Vector3f& angle) {
  const float square = angle.squaredNorm();
  const Vector3f v = (0.5F - square * (1.0F / 48.0F)) * angle;
  return Quaternionf{1.0F - square * 0.125F, v.x(), v.y(), v.z()};
}

// The shortest rotation that brings `up` (body frame) onto the earth's z axis.
Quaternionf upright(const Vector3f& up) {
  const Vector3f cross = up.cross(Vector3f::UnitZ());
  const Quaternionf q{up.norm() + up.z(), cross.x(), cross.y(), cross.z()};
  return q.normalized();
}

// A repeated time is a sample seen before, not a bad one.
SensorState classify(Microseconds now, Microseconds time, SampleQuality quality, bool usable_value,
                     const std::optional<Microseconds>& last, Microseconds stale_time) {
  const bool usable = quality == SampleQuality::valid && usable_value && time <= now && now - time <= stale_time;
  if (usable && (!last || time > *last)) {
    return SensorState::fresh;
  }
  if (!last || now - *last > stale_time) {
    return SensorState::failed;
  }
  return usable && time == *last ? SensorState::coasting : SensorState::lost;
}

// A saturated accelerometer reads less than there is: integrating its full scale gives a height that is too low, so
// control starts late, which is safe.
SampleQuality integrable(SampleQuality quality) {
  return quality == SampleQuality::saturated ? SampleQuality::valid : quality;
}

}  // namespace

MotionEstimator::MotionEstimator(const MotionPlan& plan) : plan_{plan}, pad_window_{plan}, trajectory_{at_rest({})} {}

void MotionEstimator::update(const Inputs& inputs) {
  follow_gyro(inputs.time, inputs.gyro);
  follow_accelerometer(inputs);
}

void MotionEstimator::follow_gyro(Microseconds now, const GyroSample& sample) {
  gyro_ = classify(now, sample.time, sample.quality, is_within(sample.rate_rad_s, largest_rate_rad_s), gyro_time_,
                   plan_.stale_time);
  if (gyro_ != SensorState::fresh) {
    return;
  }
  const Vector3 rate = minus(sample.rate_rad_s, bias());
  if (gyro_time_) {
    const float dt_s = seconds(std::min(sample.time - *gyro_time_, plan_.stale_time));
    const Vector3f turned = (0.5F * dt_s) * (eigen(rate) + eigen(rate_rad_s_));
    roll_angle_rad_.add(turned.x());
    const auto& a = trajectory_.attitude;
    const Quaternionf next = (Quaternionf{a.w, a.x, a.y, a.z} * small_rotation(turned)).normalized();
    trajectory_.attitude = {next.w(), next.x(), next.y(), next.z()};
  }
  rate_rad_s_ = rate;
  gyro_time_ = sample.time;
}

void MotionEstimator::follow_accelerometer(const Inputs& inputs) {
  // The second accelerometer stands in, tick by tick, when the first has nothing usable.
  for (const AccelerometerSample& sample : inputs.accelerometers) {
    accelerometer_ = classify(inputs.time, sample.time, integrable(sample.quality),
                              is_within(sample.specific_force_m_s2, largest_specific_force_m_s2), accelerometer_time_,
                              plan_.stale_time);
    if (accelerometer_ == SensorState::fresh) {
      specific_force_m_s2_ = sample.specific_force_m_s2;
      integrate(sample.time);
      break;
    }
    if (accelerometer_ == SensorState::coasting) {
      break;
    }
  }
  if (in_flight_ || accelerometer_ == SensorState::coasting) {
    return;
  }
  if (accelerometer_ == SensorState::fresh && gyro_ == SensorState::fresh) {
    pad_window_.update(inputs.time, inputs.gyro.rate_rad_s, specific_force_m_s2_);
  } else {
    pad_window_.interrupt(inputs.time);
  }
}

void MotionEstimator::integrate(Microseconds time) {
  const Microseconds previous = accelerometer_time_.value_or(time);
  accelerometer_time_ = time;
  const float filtered = axial_.update(time, specific_force_m_s2_.x);
  if (!in_flight_ && (filtered < thrust_threshold_m_s2 || time - trajectory_.since > longest_window)) {
    trajectory_ = at_rest(time);
    return;
  }
  const float dt_s = seconds(time - previous);
  const auto& a = trajectory_.attitude;
  const Vector3f acceleration = Quaternionf{a.w, a.x, a.y, a.z}.toRotationMatrix() * eigen(specific_force_m_s2_) -
                                Vector3f{0.0F, 0.0F, standard_gravity_m_s2};
  const Vector3f old_velocity = eigen(trajectory_.velocity_m_s);
  const Vector3f velocity = old_velocity + (0.5F * dt_s) * (eigen(trajectory_.acceleration_m_s2) + acceleration);
  const Vector3f position = eigen(trajectory_.position_m) + (0.5F * dt_s) * (old_velocity + velocity);
  trajectory_.acceleration_m_s2 = plain(acceleration);
  trajectory_.velocity_m_s = plain(velocity);
  trajectory_.position_m = plain(position);
}

MotionEstimator::Trajectory MotionEstimator::at_rest(Microseconds time) const {
  Trajectory result;
  const Vector3f axis_up = Vector3f::UnitX();
  const auto& pad = pad_window_.average();
  const Quaternionf q = upright(pad ? eigen(pad->specific_force_m_s2) : axis_up);
  result.attitude = {q.w(), q.x(), q.y(), q.z()};
  result.guide_axis = plain(q * axis_up);
  result.since = time;
  return result;
}

Vector3 MotionEstimator::bias() const {
  const auto& pad = pad_window_.average();
  return pad ? pad->gyro_bias_rad_s : Vector3{};
}

void MotionEstimator::begin_flight() {
  in_flight_ = true;
  roll_angle_rad_.reset();
  if (plan_.height_origin != HeightOrigin::replay) {
    trajectory_.position_m = Vector3{};
  }
  if (plan_.height_origin == HeightOrigin::from_detection) {
    trajectory_.velocity_m_s = Vector3{};
  }
}

void MotionEstimator::begin_tunnel_run() {
  in_flight_ = true;
  roll_angle_rad_.reset();
}

void MotionEstimator::return_to_pad() { in_flight_ = false; }

Motion MotionEstimator::motion(Microseconds now) const {
  Motion result;
  const auto& a = trajectory_.attitude;
  const Vector3f axis = Quaternionf{a.w, a.x, a.y, a.z}.toRotationMatrix().col(0);
  const float gap_s = gyro_time_ ? seconds(std::min(now - *gyro_time_, plan_.stale_time)) : 0.0F;
  result.roll_angle = Angle::from_radians(roll_angle_rad_.value() + gap_s * rate_rad_s_.x);
  result.roll_rate_rad_s = rate_rad_s_.x;
  result.specific_force_m_s2 = specific_force_m_s2_;
  result.height_m = trajectory_.position_m.z;
  result.distance_along_guide_m = eigen(trajectory_.position_m).dot(eigen(trajectory_.guide_axis));
  result.speed_m_s = eigen(trajectory_.velocity_m_s).dot(eigen(trajectory_.guide_axis));
  result.vertical_speed_m_s = trajectory_.velocity_m_s.z;
  result.tilt = atan2(std::sqrt(axis.x() * axis.x() + axis.y() * axis.y()), axis.z());
  result.gyro = gyro_;
  result.accelerometer = accelerometer_;
  result.at_rest_for = pad_window_.at_rest_for(now);
  result.thrust_since = trajectory_.since;
  return result;
}

}  // namespace fantail::core
