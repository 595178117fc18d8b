// SPDX-License-Identifier: MIT
#include "sim/twist.hpp"

#include <cmath>
#include <numbers>

namespace fantail::sim {

double Twist::wrapped_rad(const Quaternion& attitude) const {
  const Quaternion turned = to_upright_ * attitude;
  return std::copysign(2.0 * angle_off(std::abs(turned.w), std::abs(turned.x)), turned.w * turned.x);
}

void Twist::follow(const Quaternion& attitude) {
  constexpr double half_turn = std::numbers::pi;
  const double before_rad = wrapped_rad_;
  wrapped_rad_ = wrapped_rad(attitude);
  const double change_rad = wrapped_rad_ - before_rad;
  rad_ += change_rad > half_turn    ? change_rad - 2.0 * half_turn
          : change_rad < -half_turn ? change_rad + 2.0 * half_turn
                                    : change_rad;
}

}  // namespace fantail::sim
