// SPDX-License-Identifier: MIT
#include "core/dormancy_gate.hpp"

#include <algorithm>
#include <cmath>

#include "core/height_error.hpp"

namespace fantail::core {
namespace {

// Drag makes the reading negative once the thrust is over; an accelerometer that reads too much must not hide that.
constexpr float coast_m_s2 = 0.15F * standard_gravity_m_s2;
// Nothing but a motor pushes with this, before the parachute.
constexpr float boost_m_s2 = 1.0F * standard_gravity_m_s2;
constexpr Microseconds hold{100'000};

// Slower, what reads like coasting may be a rocket that somebody carries or lays down.
constexpr float least_speed_m_s = 15.0F;

// Further down than the errors of speed and density make of a level top.
constexpr float past_pressure = 0.98F;

// Density over that at the place of lift-off, in the standard atmosphere: (1 - 2.2558e-5 h)^4.2559. The exponent is 4
// and a quarter, because roots are the same in every C library and powers are not: off by 0.2 % at 10 km.
float density_ratio(float height_m) {
  const float temperature_ratio = std::clamp(1.0F - 2.2558e-5F * height_m, 0.1F, 1.2F);
  const float square = temperature_ratio * temperature_ratio;
  return square * square * std::sqrt(std::sqrt(temperature_ratio));
}

}  // namespace

void DormancyGate::update(Microseconds now, const Motion& motion, bool accelerometers_agree,
                          std::optional<float> by_barometer) {
  if (plan_.until == DormantUntil::guide) {
    return;
  }
  moves_ = moves_ || motion.speed_m_s > least_speed_m_s;
  is_unsure_ = is_unsure_ || motion.accelerometer == SensorState::failed || motion.rate_is_lower_bound;
  const bool sure = moves_ && !is_unsure_ && accelerometers_agree;
  watch_burn(now, motion);
  watch_pressure(motion, sure);
  watch_height(now, motion, sure, by_barometer);
}

// Meets DOR-2.
void DormancyGate::watch_burn(Microseconds now, const Motion& motion) {
  if (motion.accelerometer != SensorState::fresh) {
    if (motion.accelerometer != SensorState::coasting) {
      interrupt();
    }
    return;
  }
  const float axial_m_s2 = axial_.update(now, motion.specific_force_m_s2.x);
  if (axial_m_s2 < coast_m_s2) {
    coasts_since_ = coasts_since_.value_or(now);
    thrust_since_.reset();
  } else {
    coasts_since_.reset();
    thrust_since_ = axial_m_s2 > boost_m_s2 ? std::optional{thrust_since_.value_or(now)} : std::nullopt;
  }
  if (thrust_since_ && pause_since_ && now - *thrust_since_ >= hold) {
    pauses_ += *thrust_since_ - *pause_since_;
    pause_since_.reset();
    is_burnt_out_ = false;
  }
  if (coasts_since_ && now - *coasts_since_ >= hold) {
    pause_since_ = pause_since_.value_or(*coasts_since_);
    is_burnt_out_ = is_burnt_out_ || (moves_ && now - motion.thrust_since - pauses_ >= burn_clock_);
  }
}

void DormancyGate::watch_pressure(const Motion& motion, bool sure) {
  const float pressure = density_ratio(motion.height_m) * motion.speed_squared_m2_s2;
  // Written so that what is no number counts as no fall.
  if (!(pressure < largest_pressure_)) {
    largest_pressure_ = pressure;
    is_past_pressure_ = false;
  } else if (sure && pressure < past_pressure * largest_pressure_) {
    is_past_pressure_ = true;
  }
}

// Meets DOR-2.
void DormancyGate::watch_height(Microseconds now, const Motion& motion, bool sure, std::optional<float> by_barometer) {
  const float least_m = motion.height_m - motion_error(plan_, now, motion).height_m;
  is_past_height_ = is_past_height_ || (sure && std::max(least_m, by_barometer.value_or(least_m)) > plan_.height_m);
}

bool DormancyGate::is_open() const {
  switch (plan_.until) {
    case DormantUntil::guide: return true;
    case DormantUntil::burn_out: return is_burnt_out_;
    case DormantUntil::max_dynamic_pressure: return is_past_pressure_;
    case DormantUntil::height: return is_past_height_;
    case DormantUntil::burn_out_and_height: return is_burnt_out_ && is_past_height_;
    case DormantUntil::max_dynamic_pressure_and_height: return is_past_pressure_ && is_past_height_;
  }
  return false;
}

}  // namespace fantail::core
