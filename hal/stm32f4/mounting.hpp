// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "hal/sample.hpp"

namespace fantail::hal::stm32f4 {

enum class SensorAxis : std::uint8_t { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };

/// Defined nowhere: a mounting that mirrors does not compile.
void this_mounting_is_not_a_rotation();

/// How a sensor is soldered into the rocket: which of its axes points along the rocket's x (to the nose), y and z.
class Mounting {
 public:
  consteval Mounting(SensorAxis along_x, SensorAxis along_y, SensorAxis along_z) : axes_{along_x, along_y, along_z} {
    if (!is_rotation(axes_)) {
      this_mounting_is_not_a_rotation();
    }
  }

  using Axes = std::array<SensorAxis, 3>;
  /// Three different axes, right-handed as the rocket's are: with one sign wrong the roll would be steered backwards.
  [[nodiscard]] static constexpr bool is_rotation(const Axes& axes) {
    // Where the rocket's axes go, as a permutation; its determinant is the sign of that permutation times the signs.
    const std::size_t x = index(axes[0]);
    const std::size_t y = index(axes[1]);
    const std::size_t z = index(axes[2]);
    if (x == y || y == z || z == x) {
      return false;
    }
    const bool even = (x + 1) % 3 == y;
    const bool mirrored = negative(axes[0]) != (negative(axes[1]) != negative(axes[2]));
    return even != mirrored;
  }

  /// The sensor's counts, along the rocket's axes. Full scale stays full scale when its sign changes: whoever reads it
  /// takes either end of the range for "at least this much".
  [[nodiscard]] constexpr Counts turned(const Counts& sensor) const {
    Counts rocket{};
    for (std::size_t i = 0; i < rocket.size(); ++i) {
      const std::int16_t count = sensor[index(axes_[i])];
      rocket[i] = negative(axes_[i]) ? negated(count) : count;
    }
    return rocket;
  }

 private:
  [[nodiscard]] static constexpr std::size_t index(SensorAxis axis) { return static_cast<std::size_t>(axis) / 2; }
  [[nodiscard]] static constexpr bool negative(SensorAxis axis) { return static_cast<std::size_t>(axis) % 2 == 1; }
  [[nodiscard]] static constexpr std::int16_t negated(std::int16_t count) {
    using Limits = std::numeric_limits<std::int16_t>;
    if (count == Limits::max()) {
      return Limits::min();
    }
    return count == Limits::min() ? Limits::max() : static_cast<std::int16_t>(-count);
  }

  Axes axes_;
};

}  // namespace fantail::hal::stm32f4
