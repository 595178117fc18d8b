// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "core/flight_plan.hpp"
#include "sim/rotation.hpp"

namespace fantail::sim {

/// The axes of the rocket as a sensor sees them that is soldered in like this: x, y and z.
using AxesSeen = std::array<std::array<double, 3>, 3>;

[[nodiscard]] constexpr bool is_rotation(const core::SensorMounting& mounting) {
  return static_cast<std::size_t>(mounting.to_nose) / 2 != static_cast<std::size_t>(mounting.along_y) / 2;
}

/// For a mounting that is a rotation.
[[nodiscard]] constexpr AxesSeen axes_seen(const core::SensorMounting& mounting) {
  const auto unit = [](core::SensorAxis axis) {
    std::array<double, 3> v{};
    v[static_cast<std::size_t>(axis) / 2] = static_cast<std::size_t>(axis) % 2 == 0 ? 1.0 : -1.0;
    return v;
  };
  const std::array<double, 3> x = unit(mounting.to_nose);
  const std::array<double, 3> y = unit(mounting.along_y);
  return {x, y, {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]}};
}

}  // namespace fantail::sim
