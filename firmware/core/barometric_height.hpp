// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/flight_plan.hpp"
#include "core/height_error.hpp"
#include "core/inputs.hpp"
#include "core/low_pass.hpp"
#include "core/motion_estimator.hpp"

namespace fantail::core {

/// What the barometer is good for in a tick.
enum class BarometerState : std::uint8_t {
  silent,     ///< no usable sample for 0.1 s, or none from the pad to compare with
  on_pad,     ///< no launch yet: what it reads is the pressure of the pad
  used,       ///< height and vertical speed follow it, within the error of the accelerometer
  too_fast,   ///< the rocket's own flow disturbs the ports, or did half a second ago
  disagrees,  ///< further from the accelerometer's height than both may err, or was so half a second ago
  alone,      ///< no accelerometer measures the flight: alone it counts for nothing
};
/// How many values BarometerState has: one that is read must be below.
inline constexpr std::size_t barometer_states = 6;

/// Height and vertical speed by a barometer and the accelerometer together.
///
/// The accelerometer's integral goes on untouched. What is added to it follows the difference to the barometer with a
/// critically damped filter of 1 rad/s, and is never more than the plan says the accelerometer may be wrong by. So a
/// barometer that lies can do no more than an accelerometer as bad as the plan allows. It begins no launch. Apogee is
/// where the accelerometer says so and both together do: it never comes early for the barometer's sake.
///
/// Its own error: the air at the pad is colder or warmer than planned, and every height scales with it; flow over the
/// ports, a tenth of the dynamic pressure; air that comes late through them; 5 m for all else. Above 100 m/s it is not
/// used at all, which keeps the shocks of the speed of sound out, too. Where it differs from the accelerometer by more
/// than both may err, one of them lies, and it is not used: a port that is blocked, an ejection charge, sunlight on the
/// device, a reading that stands still.
class BarometricHeight {
 public:
  /// Parts of a plan that has passed validate().
  [[gnu::cold]] BarometricHeight(const SensorsPlan& sensors, const DormancyPlan& errors)
      : pad_temperature_k_{273.15F + sensors.air_temperature_c},
        temperature_error_{sensors.air_temperature_error_k / pad_temperature_k_},
        errors_{errors} {}

  /// In every tick. `motion` as the accelerometer has it; `flies`: since launch detection.
  void update(const Inputs& inputs, bool flies, const Motion& motion);

  /// Adds what the barometer makes of height and vertical speed.
  void correct(Motion& motion) const {
    motion.height_m += height_m_;
    motion.vertical_speed_m_s += vertical_speed_m_s_;
  }

  /// By both together. Where they are wrong, apogee may be noticed late, and never early for the barometer's sake.
  [[nodiscard]] bool climbs(const Motion& motion) const {
    return motion.vertical_speed_m_s + vertical_speed_m_s_ >= 0.0F;
  }

  /// The rocket is above this, by the barometer with its error, and by the accelerometer without: neither alone opens a
  /// gate. A barometer that is wrong by more than its error may make it too high, by as much as the accelerometer reads
  /// too high. Empty while the barometer is not used, or differs by more than its own error.
  [[nodiscard]] std::optional<float> least_height_m() const { return least_height_m_; }

  /// Of the last update().
  [[nodiscard]] BarometerState state() const { return state_; }

  /// A launch has been detected, or nobody saw what happened since the last update.
  void begin_flight() {
    height_m_ = vertical_speed_m_s_ = 0.0F;
    interrupt();
  }
  void interrupt() {
    agrees_since_.reset();
    used_at_.reset();
    least_height_m_.reset();
  }

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(pad_pressure_pa_, last_time_, agrees_since_, used_at_, least_height_m_, height_m_, vertical_speed_m_s_);
    visit.below(barometer_states, state_);
  }

 private:
  void compare(const Inputs& inputs, const Motion& motion);
  void follow(Microseconds time, float difference_m, const MotionError& most);
  void reject(BarometerState why);
  [[nodiscard]] float error_m(float height_m, const Motion& motion) const;

  float pad_temperature_k_;
  float temperature_error_;  ///< share of any height
  DormancyPlan errors_;
  LowPass pad_pressure_pa_{0.16F};  // a second
  std::optional<Microseconds> last_time_;
  std::optional<Microseconds> agrees_since_;
  std::optional<Microseconds> used_at_;
  std::optional<float> least_height_m_;
  float height_m_ = 0.0F;  ///< what is added
  float vertical_speed_m_s_ = 0.0F;
  BarometerState state_ = BarometerState::silent;
};

}  // namespace fantail::core
