// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/vector3.hpp"

namespace fantail::core {

/// True for every number; false for infinities and NaN, whose exponent is all ones. Not std::isfinite, which may be a
/// call into the C library of the target.
[[nodiscard]] constexpr bool is_finite(float value) {
  constexpr std::uint32_t exponent = 0x7F80'0000;
  return (std::bit_cast<std::uint32_t>(value) & exponent) != exponent;
}

/// True if all three components are.
[[nodiscard]] constexpr bool is_finite(const Vector3& v) { return is_finite(v.x) && is_finite(v.y) && is_finite(v.z); }

/// False for NaN too. For samples this is the better question: a finite 1e38 makes an infinity in the next square, and
/// an infinity in a filter never leaves it.
[[nodiscard]] constexpr bool is_within(float value, float limit) { return std::abs(value) <= limit; }

/// Each component by itself: the length may be sqrt(3) times the limit.
[[nodiscard]] constexpr bool is_within(const Vector3& v, float limit) {
  return is_within(v.x, limit) && is_within(v.y, limit) && is_within(v.z, limit);
}

}  // namespace fantail::core
