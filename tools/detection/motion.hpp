// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace fantail::detection {

/// What truly happens to the rocket, a millisecond a step. It turns about one axis across it only (its y), so that up
/// is (cos pitch, 0, sin pitch) in its own frame. Room for the longest event: nothing is allocated while events are
/// gone through.
struct Motion {
  static constexpr std::size_t most = 3'000;

  std::size_t length = 0;
  double start_pitch_rad = 0.0;         ///< of the axis from the vertical
  bool turns = false;                   ///< else every pitch rate is zero
  std::array<float, most> axial_m_s2;   ///< acceleration along the axis, without gravity
  std::array<float, most> across_m_s2;  ///< likewise along z
  std::array<float, most> carried;      ///< share of the weight that something carries: 1 at rest, 0 in free fall
  std::array<float, most> pitch_rate_rad_s;

  // Of launches only.
  std::size_t ignition = 0;
  double peak_thrust_m_s2 = 0.0;
  std::array<float, most> thrust_m_s2;  ///< axial specific force without the vibration
  std::array<float, most> distance_m;   ///< along the guide from where it stood

  void begin(std::size_t steps, double pitch_rad) {
    length = steps;
    start_pitch_rad = pitch_rad;
    turns = false;
    ignition = 0;
    for (std::size_t i = 0; i < steps; ++i) {
      axial_m_s2[i] = across_m_s2[i] = pitch_rate_rad_s[i] = 0.0F;
      carried[i] = 1.0F;
    }
  }
};

}  // namespace fantail::detection
