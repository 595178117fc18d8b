// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "sim/random.hpp"
#include "sim/units.hpp"

namespace fantail::sim {

/// How the sensors are shaken while the motor burns, all of them alike: what a vibration recorder beside them would
/// show, so it holds where they sit and not at the centre of gravity. Nothing by default.
struct VibrationParameters {
  double specific_force_m_s2 = 0.0;  ///< standard deviation on each axis
  double rate_rad_s = 0.0;           ///< standard deviation about each axis
  double frequency_hz = 150.0;       ///< the middle of its band, 1 to 450; the band is a fifth of it
};

/// What shaking adds to the motion of a sensor at one instant.
struct Shaking {
  Vector3 specific_force_m_s2;
  Vector3 rate_rad_s;
};

/// Band-limited noise on six axes, one millisecond a step: resonances driven by white noise, of which the difference
/// over two steps is what shakes. It is zero at 0 Hz: a resonance alone lets enough through there that the rocket would
/// gain a speed of metres per second and turn by degrees.
class Vibration {
 public:
  Vibration(const VibrationParameters& parameters, Random random);

  [[nodiscard]] bool is_there() const { return parameters_.specific_force_m_s2 > 0.0 || parameters_.rate_rad_s > 0.0; }

  /// That of the next millisecond.
  [[nodiscard]] Shaking next();

 private:
  struct Resonance {
    double last = 0.0;
    double one_before = 0.0;
  };

  VibrationParameters parameters_;
  Random random_;
  double keep_last_ = 0.0;
  double keep_one_before_ = 0.0;
  double drive_ = 0.0;  ///< so that each difference has standard deviation 1
  std::array<Resonance, 6> resonances_{};
};

}  // namespace fantail::sim
