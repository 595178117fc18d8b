// SPDX-License-Identifier: MIT
#include "core/barometric_height.hpp"

#include <algorithm>
#include <cmath>

#include "core/pressure_height.hpp"

namespace fantail::core {
namespace {

// Devices have something new every 10 ms or so.
constexpr Microseconds longest_silence{100'000};
constexpr Microseconds settling_time{500'000};

// From vacuum, nearly, to the bottom of a mine.
constexpr float least_pressure_pa = 1'000.0F;
constexpr float largest_pressure_pa = 120'000.0F;

constexpr float fastest_m_s = 100.0F;
constexpr float port_coefficient = 0.1F;
constexpr float port_delay_s = 0.1F;
constexpr float other_error_m = 5.0F;

constexpr float bandwidth_rad_s = 1.0F;

bool is_usable(const PressureSample& sample, Microseconds now, const std::optional<Microseconds>& last) {
  return sample.pressure_pa >= least_pressure_pa && sample.pressure_pa <= largest_pressure_pa &&
         is_current(now, sample.time, longest_silence) && (!last || sample.time > *last);
}

}  // namespace

// Meets BAR-1.
void BarometricHeight::update(const Inputs& inputs, bool flies, const Motion& motion) {
  const bool is_new = inputs.barometer && is_usable(*inputs.barometer, inputs.time, last_time_);
  if (is_new) {
    last_time_ = inputs.barometer->time;
  } else if (!last_time_ || !is_current(inputs.time, *last_time_, longest_silence)) {
    state_ = BarometerState::silent;
    interrupt();
    return;
  }
  if (!flies) {
    state_ = BarometerState::on_pad;
    interrupt();
    if (is_new && motion.at_rest_for > Microseconds{0}) {
      pad_pressure_pa_.update(inputs.barometer->time, inputs.barometer->pressure_pa);
    }
  } else if (motion.accelerometer == SensorState::failed || motion.speed_is_lower_bound) {
    reject(BarometerState::alone);
  } else if (is_new) {
    compare(inputs, motion);
  }
}

void BarometricHeight::compare(const Inputs& inputs, const Motion& motion) {
  const auto pad_pa = pad_pressure_pa_.output();
  if (!pad_pa) {
    return reject(BarometerState::silent);
  }
  if (!(motion.speed_squared_m2_s2 <= fastest_m_s * fastest_m_s)) {
    interrupt();
    state_ = BarometerState::too_fast;
    return;
  }
  const Microseconds time = inputs.barometer->time;
  const float height_m = pressure_height_m(inputs.barometer->pressure_pa / *pad_pa, pad_temperature_k_);
  const float believed_m = motion.height_m - motion.vertical_speed_m_s * seconds(inputs.time - time);
  const float own_error_m = error_m(height_m, motion);
  const MotionError most = motion_error(errors_, inputs.time, motion);
  const float difference_m = height_m - believed_m;
  // Written so that what is no number agrees with nothing.
  if (!(std::abs(difference_m) <= own_error_m + most.height_m)) {
    return reject(BarometerState::disagrees);
  }
  agrees_since_ = agrees_since_.value_or(time);
  if (time - *agrees_since_ < settling_time) {
    return;
  }
  state_ = BarometerState::used;
  // Both may be right and yet differ by more than the barometer alone may err. But then one of them is near the end of
  // what it may be wrong by, and nobody knows which.
  least_height_m_ = std::abs(difference_m) <= own_error_m ? std::optional{std::min(height_m - own_error_m, believed_m)}
                                                          : std::nullopt;
  follow(time, difference_m, most);
}

void BarometricHeight::follow(Microseconds time, float difference_m, const MotionError& most) {
  const float dt_s = used_at_ ? seconds(time - *used_at_) : 0.0F;
  used_at_ = time;
  const float left_m = difference_m - height_m_;
  height_m_ += dt_s * (vertical_speed_m_s_ + 2.0F * bandwidth_rad_s * left_m);
  vertical_speed_m_s_ += dt_s * bandwidth_rad_s * bandwidth_rad_s * left_m;
  // Written so that what is no number comes to the limit.
  const auto within = [](float value, float limit) {
    const float largest = std::abs(limit);
    return std::abs(value) <= largest ? value : std::copysign(largest, value);
  };
  height_m_ = within(height_m_, most.height_m);
  vertical_speed_m_s_ = within(vertical_speed_m_s_, most.vertical_speed_m_s);
}

// What it has said before may have been a lie, too.
void BarometricHeight::reject(BarometerState why) {
  state_ = why;
  begin_flight();
}

float BarometricHeight::error_m(float height_m, const Motion& motion) const {
  return temperature_error_ * std::abs(height_m) +
         port_coefficient / (2.0F * standard_gravity_m_s2) * motion.speed_squared_m2_s2 +
         port_delay_s * std::abs(motion.vertical_speed_m_s) + other_error_m;
}

}  // namespace fantail::core
