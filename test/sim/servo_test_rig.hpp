// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include "degree.hpp"
#include "sim/servo.hpp"

namespace fantail::sim {

/// Nothing but the lag, and a frame at every millisecond.
inline ServoParameters ideal() {
  return {.lag_s = 0.020,
          .delay_s = 0.0,
          .frame_period_s = 0.001,
          .rate_limit_rad_s = 1e6,
          .stop_rad = 60.0 * degree,
          .backlash_rad = 0.0,
          .pulse_centre_us = 1500.0,
          .pulse_per_degree_us = 10.0};
}

inline double pulse_us(double angle_deg) { return 1500.0 + 10.0 * angle_deg; }

/// A servo and its clock.
struct ServoRig {
  explicit ServoRig(const ServoParameters& parameters, double step_s = 0.001) : servo{parameters}, dt_s{step_s} {}

  void run(double until_s, std::optional<double> pulse) {
    const int last = static_cast<int>(std::lround(until_s / dt_s));
    for (; tick < last; ++tick) {
      servo.step(time_s(), dt_s, pulse);
    }
  }
  [[nodiscard]] double time_s() const { return tick * dt_s; }
  [[nodiscard]] double angle_deg() const { return servo.angle_rad() / degree; }

  Servo servo;
  double dt_s;
  int tick = 0;
};

}  // namespace fantail::sim
