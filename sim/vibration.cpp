// SPDX-License-Identifier: MIT
#include "sim/vibration.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "sim/elementary.hpp"
#include "sim/rotation.hpp"

namespace fantail::sim {

Vibration::Vibration(const VibrationParameters& parameters, Random random) : parameters_{parameters}, random_{random} {
  constexpr double tick_s = 1e-3;
  const double band_hz = 0.2 * parameters.frequency_hz;
  const double radius = exponential(-std::numbers::pi * band_hz * tick_s);
  keep_last_ = 2.0 * radius * sine_cosine(2.0 * std::numbers::pi * parameters.frequency_hz * tick_s).cosine;
  keep_one_before_ = -radius * radius;
  // x[n] - x[n-2] of such a resonance has the variance 2 drive^2 / (1 - radius^2).
  drive_ = std::sqrt(0.5 * (1.0 - radius * radius));
}

Shaking Vibration::next() {
  const std::array<double, 6> drawn = random_.gaussians<6>();
  std::array<double, 6> now{};
  for (std::size_t i = 0; i < now.size(); ++i) {
    Resonance& r = resonances_[i];
    const double next = keep_last_ * r.last + keep_one_before_ * r.one_before + drive_ * drawn[i];
    now[i] = next - r.one_before;
    r = {.last = next, .one_before = r.last};
  }
  return {.specific_force_m_s2 = parameters_.specific_force_m_s2 * Vector3{.x = now[0], .y = now[1], .z = now[2]},
          .rate_rad_s = parameters_.rate_rad_s * Vector3{.x = now[3], .y = now[4], .z = now[5]}};
}

}  // namespace fantail::sim
