// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

namespace fantail {
inline constexpr double degree = std::numbers::pi / 180.0;  ///< in radians: tests state angles as people do
}
