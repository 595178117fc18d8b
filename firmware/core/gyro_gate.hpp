// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/flight_plan.hpp"
#include "core/inputs.hpp"
#include "core/time.hpp"
#include "core/vector3.hpp"

namespace fantail::core {

/// What a sensor is good for in a tick.
enum class SensorState : std::uint8_t {
  fresh,     ///< a new, usable sample
  coasting,  ///< no new sample yet; the last one is young enough to go on with
  lost,      ///< this tick's sample cannot be used, or not yet
  failed,    ///< no usable sample for longer than the plan allows
};
/// How many values SensorState has: one that is read must be below.
inline constexpr std::size_t sensor_states = 4;

/// A sample that is neither from the future nor older than the plan allows.
[[nodiscard]] constexpr bool is_current(Microseconds now, Microseconds time, Microseconds stale_time) {
  return time <= now && time >= now - stale_time;  // not by its age, which of a time that is nonsense does not fit
}

/// Which samples of the gyro are accepted.
///
/// A gyro that falls silent in flight is waited for as long as the plan says, and believed again when five samples in a
/// row agree: what a device says while it starts again does not. On the pad it is believed at once, because nothing
/// moves a canard there.
///
/// A gyro at the end of its range says that the rocket turns faster than this, and in which sense. That is believed
/// when the rate was on its way there; what jumps there is a fault.
class GyroGate {
 public:
  /// Of the plan it takes `stale_time` and `longest_gyro_gap`.
  explicit GyroGate(const MotionPlan& plan) : stale_time_{plan.stale_time}, longest_gap_{plan.longest_gyro_gap} {}

  /// fresh: the sample is accepted. `roll_rate_rad_s`: of the last one that was.
  SensorState update(Microseconds now, const GyroSample& sample, bool flies, float roll_rate_rad_s);

  /// Could this sample be accepted, if it followed a rate without a gap?
  [[nodiscard]] bool is_usable(Microseconds now, const GyroSample& sample, float roll_rate_rad_s) const;

  /// When the last accepted one was measured; empty before the first.
  [[nodiscard]] const std::optional<Microseconds>& last_time() const { return last_time_; }

  /// What lies before this instant has been bridged by somebody else.
  void skip_to(Microseconds time) { last_time_ = time; }

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(last_time_, returning_time_, returning_rate_rad_s_, agreeing_);
  }

 private:
  [[nodiscard]] bool is_back(const GyroSample& sample);

  Microseconds stale_time_;
  Microseconds longest_gap_;
  std::optional<Microseconds> last_time_;

  // Of a gyro that was silent: its last sample, and how many up to it agree.
  Microseconds returning_time_{};
  Vector3 returning_rate_rad_s_;
  std::uint32_t agreeing_ = 0;
};

}  // namespace fantail::core
