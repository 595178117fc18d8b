// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fantail::detection {

/// The parts of a flight that comes down again, in their order.
enum class Part : std::uint8_t { launch, coast, drogue, descent, main, landing, lying, crew };
inline constexpr std::size_t flight_parts = 8;
inline constexpr std::array<std::string_view, flight_parts> part_names{"launch", "coast",   "drogue", "descent",
                                                                       "main",   "landing", "lying",  "crew"};

/// Steps from the first one up to, but not including, the last one.
struct Steps {
  std::size_t from = 0;
  std::size_t to = 0;
  [[nodiscard]] bool has(std::size_t step) const { return step >= from && step < to; }
};

/// Why a flight is not detected, or not controlled, where the sensors are the reason: one accelerometer that reads too
/// little or nothing for a while, or a silent gyro.
struct SensorTrouble {
  std::size_t accelerometer = 0;  ///< which
  Steps low{};
  float low_by_m_s2 = 0.0F;  ///< taken off in these steps
  float low_share = 0.0F;    ///< of what is felt, likewise
  Steps accelerometer_silent{};
  Steps gyro_silent{};
};

/// What truly happens to the rocket, a millisecond a step. It turns about one axis across it only (its y, before it
/// rolls), so that up is (cos pitch, 0, sin pitch) in a frame that does not roll with it. Room for the longest event:
/// nothing is allocated while events are gone through.
struct Motion {
  static constexpr std::size_t most = 64'000;

  std::size_t length = 0;
  double start_pitch_rad = 0.0;         ///< of the axis from the vertical
  bool turns = false;                   ///< else every pitch rate is zero
  bool rolls = false;                   ///< else every roll rate is zero
  std::array<float, most> axial_m_s2;   ///< acceleration along the axis, without gravity
  std::array<float, most> across_m_s2;  ///< likewise along z
  /// Share of the weight that something carries: 1 at rest, 0 in free fall, more in a shock straight up.
  std::array<float, most> carried;
  std::array<float, most> pitch_rate_rad_s;
  std::array<float, most> roll_rate_rad_s;

  // Of launches only.
  std::size_t ignition = 0;
  double peak_thrust_m_s2 = 0.0;
  std::array<float, most> thrust_m_s2;  ///< axial specific force without the vibration
  std::array<float, most> distance_m;   ///< along the guide from where it stood
  std::size_t still_from = 0;           ///< of a rail that was raised

  // Of flights that come down only.
  std::size_t flight_end = 0;  ///< until here a detection is right
  SensorTrouble trouble{};
  std::array<std::size_t, flight_parts> part_begin{};

  [[nodiscard]] Part part_of(std::size_t step) const {
    std::size_t part = 0;
    while (part + 1 < flight_parts && step >= part_begin[part + 1]) {
      ++part;
    }
    return static_cast<Part>(part);
  }

  void begin(std::size_t steps, double pitch_rad) {
    start_pitch_rad = pitch_rad;
    turns = rolls = false;
    ignition = still_from = flight_end = 0;
    trouble = {};
    part_begin = {};
    length = 0;
    stand(steps);
  }

  /// At rest for so many steps more.
  void stand(std::size_t steps) {
    for (std::size_t i = length; i < length + steps; ++i) {
      axial_m_s2[i] = across_m_s2[i] = pitch_rate_rad_s[i] = roll_rate_rad_s[i] = 0.0F;
      carried[i] = 1.0F;
    }
    length += steps;
  }
};

}  // namespace fantail::detection
