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

// The longest allowed hold (0.5 s) and as much again for a motor that comes up slowly. Someone who carries the rocket
// about must not collect height for longer than that.
constexpr Microseconds longest_window{1'000'000};

// Axial readings of a rocket that stands in its guide, and for how long they must last: a thrust that falls off passes
// through them faster, and in free flight the axis reads the drag, which is negative.
constexpr float least_support_m_s2 = 0.8F * standard_gravity_m_s2;
constexpr Microseconds support_time{100'000};

constexpr Microseconds longest_bridge{1'000'000};  // far beyond what a reset takes; it bounds the work
constexpr Microseconds bridge_step{1'000};
constexpr int most_bridge_steps = 251;  // all in one tick; in a longer gap a step has up to 4 ms, 8 deg at 2000 deg/s

Vector3f eigen(const Vector3& v) { return {v.x, v.y, v.z}; }
Vector3 plain(const Vector3f& v) { return {v.x(), v.y(), v.z()}; }

// Back to unit length. One Newton step from a length that the last tick left within rounding of 1: no root, no
// division.
Quaternionf renormalized(const Quaternionf& q) {
  return Quaternionf{Eigen::Vector4f{(1.5F - 0.5F * q.squaredNorm()) * q.coeffs()}};
}

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

}  // namespace

MotionEstimator::MotionEstimator(const MotionPlan& plan, const SensorsPlan& sensors, TiltOrigin tilt_from)
    : plan_{plan},
      votes_{sensors.gyros == GyroRule::two_agree},
      tilts_from_guide_{tilt_from == TiltOrigin::guide},
      gyro_gate_{plan},
      pad_window_{plan},
      gyro_pair_{sensors, plan} {
  set_pad_upright();
  trajectory_ = pad_;
}

void MotionEstimator::follow(const Inputs& inputs, const GyroSample& gyro) {
  follow_gyro(inputs.time, gyro);
  follow_accelerometer(inputs);
  if (place_ == Place::pad) {
    watch_pad(inputs.time, gyro);
  }
}

void MotionEstimator::follow_gyro(Microseconds now, const GyroSample& sample) {
  const bool flies = place_ != Place::pad;
  const Microseconds last_time = gyro_gate_.last_time().value_or(sample.time);
  gyro_ = gyro_gate_.update(now, sample, flies, rate_rad_s_.x);
  if (gyro_ != SensorState::fresh) {
    return;
  }
  const Vector3 rate = without_bias(sample.rate_rad_s);
  const Microseconds gap = sample.time - last_time;  // zero of the first one, which turns nothing
  const bool was_silent = gap > plan_.stale_time;
  if (was_silent && flies) {
    turn_evenly(gap, rate);
  } else if (gap > Microseconds{0}) {
    turn(seconds(was_silent ? plan_.stale_time : gap), rate_rad_s_, rate);
  }
  rate_rad_s_ = rate;
  rate_is_lower_bound_ = sample.quality == SampleQuality::saturated;
  roll_is_bridged_ = roll_is_bridged_ || was_silent || rate_is_lower_bound_;
}

void MotionEstimator::turn(float dt_s, const Vector3& first_rate_rad_s, const Vector3& last_rate_rad_s) {
  const Vector3f turned = (0.5F * dt_s) * (eigen(last_rate_rad_s) + eigen(first_rate_rad_s));
  roll_angle_rad_.add(turned.x());
  const auto& a = trajectory_.attitude;
  const Quaternionf next = renormalized(Quaternionf{a.w, a.x, a.y, a.z} * small_rotation(turned));
  trajectory_.attitude = {next.w(), next.x(), next.y(), next.z()};
}

void MotionEstimator::bridge(const Inputs& inputs) {
  const Microseconds now = inputs.time;
  const GyroSample gyro = votes_ ? choose_gyro(inputs) : inputs.gyro;
  // Nobody saw whether the rocket still stood.
  supported_since_.reset();
  if (!gyro_gate_.last_time()) {
    return;
  }
  const Microseconds last_time = *gyro_gate_.last_time();
  const bool usable = gyro.time > last_time && gyro_gate_.is_usable(now, gyro, rate_rad_s_.x);
  const Microseconds end = usable ? gyro.time : now;
  const Vector3 last = usable ? without_bias(gyro.rate_rad_s) : rate_rad_s_;
  turn_evenly(end - last_time, last);
  rate_rad_s_ = last;
  roll_is_bridged_ = true;
  gyro_gate_.skip_to(end);
}

// As many steps as there would have been ticks, up to a bound: a rotation in one is exact for small angles only.
void MotionEstimator::turn_evenly(Microseconds time, const Vector3& last_rate_rad_s) {
  const Microseconds gap = std::clamp(time, Microseconds{0}, longest_bridge);
  const int steps = std::min(static_cast<int>(gap / bridge_step + 1), most_bridge_steps);
  const Vector3 change = minus(last_rate_rad_s, rate_rad_s_);
  const auto rate_after = [&](int step) {
    const float share = static_cast<float>(step) / static_cast<float>(steps);
    return Vector3{rate_rad_s_.x + share * change.x, rate_rad_s_.y + share * change.y,
                   rate_rad_s_.z + share * change.z};
  };
  const float dt_s = seconds(gap) / static_cast<float>(steps);
  for (int step = 0; step < steps; ++step) {
    turn(dt_s, rate_after(step), rate_after(step + 1));
  }
}

// The second accelerometer stands in, tick by tick, when the first has nothing usable. One that is merely slower, its
// sample older than the last, is waited for rather than a saturated one taken: it measures again before it is stale.
void MotionEstimator::follow_accelerometer(const Inputs& inputs) {
  if (follow_accelerometers_that_are(SampleQuality::valid, inputs)) {
    return;
  }
  if (follow_accelerometers_that_are(SampleQuality::saturated, inputs)) {
    trajectory_.is_lower_bound = trajectory_.is_lower_bound || accelerometer_ == SensorState::fresh;
    return;
  }
  const bool failed = !accelerometer_time_ || inputs.time - *accelerometer_time_ > plan_.stale_time;
  accelerometer_ = failed ? SensorState::failed : SensorState::lost;
}

bool MotionEstimator::follow_accelerometers_that_are(SampleQuality quality, const Inputs& inputs) {
  bool waits = false;
  for (const AccelerometerSample& sample : inputs.accelerometers) {
    if (sample.quality != quality || !is_current(inputs.time, sample.time, plan_.stale_time) ||
        !is_within(sample.specific_force_m_s2, largest_specific_force_m_s2)) {
      continue;
    }
    if (!accelerometer_time_ || sample.time > *accelerometer_time_) {
      accelerometer_ = SensorState::fresh;
      specific_force_m_s2_ = sample.specific_force_m_s2;
      integrate(sample.time);
      return true;
    }
    accelerometer_ = SensorState::coasting;
    waits = true;
    if (sample.time == *accelerometer_time_) {
      break;
    }
  }
  return waits;
}

// One lost sample is not motion; a sensor that stays silent might hide some.
void MotionEstimator::watch_pad(Microseconds now, const GyroSample& gyro) {
  if (gyro_ == SensorState::failed || accelerometer_ == SensorState::failed) {
    pad_window_.interrupt(now);
  } else if (gyro_ == SensorState::fresh && pad_window_.update(now, gyro.rate_rad_s, specific_force_m_s2_)) {
    set_pad_upright();
  }
}

void MotionEstimator::integrate(Microseconds time) {
  const Microseconds previous = accelerometer_time_.value_or(time);
  accelerometer_time_ = time;
  if (stands(time, previous, axial_.update(time, specific_force_m_s2_.x))) {
    // Part by part: all of pad_ would be a call to memcpy, in every tick on the pad.
    trajectory_.attitude = pad_.attitude;
    trajectory_.guide_axis = pad_.guide_axis;
    trajectory_.velocity_m_s = trajectory_.position_m = Vector3{};
    trajectory_.acceleration_m_s2 = acceleration();
    trajectory_.since = time;
    trajectory_.is_lower_bound = false;
    return;
  }
  const float dt_s = seconds(time - previous);
  const Vector3 now = acceleration();
  const Vector3f old_velocity = eigen(trajectory_.velocity_m_s);
  const Vector3f velocity = old_velocity + (0.5F * dt_s) * (eigen(trajectory_.acceleration_m_s2) + eigen(now));
  const Vector3f position = eigen(trajectory_.position_m) + (0.5F * dt_s) * (old_velocity + velocity);
  trajectory_.acceleration_m_s2 = now;
  trajectory_.velocity_m_s = plain(velocity);
  trajectory_.position_m = plain(position);
}

bool MotionEstimator::stands(Microseconds time, Microseconds previous, float axial_m_s2) {
  const bool pushed = axial_m_s2 >= thrust_threshold_m_s2;
  if (place_ == Place::pad) {
    return !pushed || time - trajectory_.since > longest_window || time - previous > plan_.stale_time;
  }
  if (place_ == Place::free || pushed || axial_m_s2 < least_support_m_s2) {
    supported_since_.reset();
    return false;
  }
  supported_since_ = supported_since_.value_or(time);
  return time - *supported_since_ >= support_time;
}

Vector3 MotionEstimator::acceleration() const {
  const auto& a = trajectory_.attitude;
  return plain(Quaternionf{a.w, a.x, a.y, a.z}.toRotationMatrix() * eigen(specific_force_m_s2_) -
               Vector3f{0.0F, 0.0F, standard_gravity_m_s2});
}

// What else there is of it stays zero.
void MotionEstimator::set_pad_upright() {
  const Vector3f axis_up = Vector3f::UnitX();
  const auto& pad = pad_window_.average();
  const Quaternionf q = upright(pad ? eigen(pad->specific_force_m_s2) : axis_up);
  pad_.attitude = {q.w(), q.x(), q.y(), q.z()};
  pad_.guide_axis = plain(q * axis_up);
}

Vector3 MotionEstimator::without_bias(const Vector3& rate_rad_s) const {
  const auto& pad = pad_window_.average();
  return pad ? minus(rate_rad_s, pad->gyro_bias_rad_s) : rate_rad_s;
}

void MotionEstimator::begin_flight(Microseconds now) {
  place_ = Place::guide;
  supported_since_.reset();
  zero_roll(now);
  if (plan_.height_origin != HeightOrigin::replay) {
    trajectory_.position_m = Vector3{};
  }
  if (plan_.height_origin == HeightOrigin::from_detection) {
    trajectory_.velocity_m_s = Vector3{};
  }
}

void MotionEstimator::return_to_pad() {
  place_ = Place::pad;
  pad_window_.require_rest();
}

float MotionEstimator::bridged_roll_rad(Microseconds now) const {
  const auto& last_time = gyro_gate_.last_time();
  return last_time ? seconds(up_to(plan_.stale_time, now - *last_time)) * rate_rad_s_.x : 0.0F;
}

void MotionEstimator::zero_roll(Microseconds now) {
  roll_is_bridged_ = false;
  roll_angle_rad_.reset();
  roll_angle_rad_.add(-bridged_roll_rad(now));
}

// Field by field into its place: a Motion that is made and then copied costs a step 60 instructions.
void MotionEstimator::motion(Microseconds now, Motion& motion) const {
  const auto& a = trajectory_.attitude;
  const Vector3f axis = Quaternionf{a.w, a.x, a.y, a.z}.toRotationMatrix().col(0);
  const Vector3f guide = eigen(trajectory_.guide_axis);
  const Vector3& position = trajectory_.position_m;
  const Vector3f velocity = eigen(trajectory_.velocity_m_s);
  motion.roll_angle = Angle::from_radians(roll_angle_rad_.value() + bridged_roll_rad(now));
  motion.roll_rate_rad_s = rate_rad_s_.x;
  motion.gyro_bias_rad_s = pad_window_.average().value_or(PadAverage{}).gyro_bias_rad_s;
  motion.specific_force_m_s2 = specific_force_m_s2_;
  motion.height_m = position.z;
  motion.horizontal_distance_m = std::sqrt(position.x * position.x + position.y * position.y);
  motion.distance_along_guide_m = eigen(position).dot(guide);
  motion.speed_m_s = velocity.dot(guide);
  motion.vertical_speed_m_s = velocity.z();
  motion.speed_squared_m2_s2 = velocity.squaredNorm();
  motion.tilt = atan2(std::sqrt(axis.x() * axis.x() + axis.y() * axis.y()), axis.z());
  motion.tilt_from_guide =
      tilts_from_guide_ ? std::optional{atan2(axis.cross(guide).norm(), axis.dot(guide))} : std::nullopt;
  motion.gyro = gyro_;
  motion.accelerometer = accelerometer_;
  motion.rate_is_lower_bound = rate_is_lower_bound_;
  motion.roll_is_bridged = roll_is_bridged_;
  motion.speed_is_lower_bound = trajectory_.is_lower_bound;
  motion.at_rest_for = pad_window_.at_rest_for(now);
  motion.has_moved = pad_window_.movement().has_moved();
  motion.has_fallen = pad_window_.movement().has_fallen();
  motion.thrust_since = trajectory_.since;
}

}  // namespace fantail::core
