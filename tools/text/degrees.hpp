// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numbers>
#include <optional>
#include <vector>

namespace fantail::text {

[[nodiscard]] constexpr double degrees(double radians) { return radians * (180.0 / std::numbers::pi); }
[[nodiscard]] constexpr double radians(double degrees) { return degrees * (std::numbers::pi / 180.0); }

[[nodiscard]] inline std::optional<double> in_degrees(const std::optional<double>& radians) {
  return radians ? std::optional{degrees(*radians)} : std::nullopt;
}
[[nodiscard]] inline std::vector<double> in_degrees(std::vector<double> values_rad) {
  std::ranges::transform(values_rad, values_rad.begin(), degrees);
  return values_rad;
}

}  // namespace fantail::text
