// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace fantail::sim {

/// How roll damping, roll torque and the normal force grow towards the speed of sound.
enum class Compressibility : std::uint8_t {
  none,             ///< not at all
  prandtl_glauert,  ///< times 1 / sqrt(1 - M^2)
};

/// From here on nothing is promised: the factor stays what it is here, 5/3, and reports say so.
inline constexpr double highest_mach_of_prandtl_glauert = 0.8;

/// On the coefficients at low speed. Mach number of either sign. Source: H. Glauert, The Effect of Compressibility on
/// the Lift of an Aerofoil, Proceedings of the Royal Society A 118 (1928); of fins with a low aspect ratio it is an
/// upper bound.
[[nodiscard]] inline double compressibility_factor(Compressibility compressibility, double mach) {
  if (compressibility == Compressibility::none) {
    return 1.0;
  }
  const double held = std::abs(mach) < highest_mach_of_prandtl_glauert ? mach : highest_mach_of_prandtl_glauert;
  return 1.0 / std::sqrt(1.0 - held * held);
}

}  // namespace fantail::sim
