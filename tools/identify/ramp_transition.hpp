// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace fantail::identify {

/// What one step of length dt does to rate p and angle phi when the roll acceleration runs straight from g0 to g1:
///   p' = decay p + rate_0 g0 + rate_1 g1,   phi' = phi + angle_p p + angle_0 g0 + angle_1 g1.
/// Exact for every step and every damping (the plant of Eq 2-3 with held damping).
struct RampTransition {
  double decay;
  double rate_0;
  double rate_1;
  double angle_p;
  double angle_0;
  double angle_1;
};

/// damping_rate_per_s and dt_s not negative.
[[nodiscard]] inline RampTransition ramp_transition(double damping_rate_per_s, double dt_s) {
  const double x = damping_rate_per_s * dt_s;
  // phi1 = (1 - e^-x) / x and so on, each phi_k = (1 / k! - phi_k+1 ...) / x of the one before.
  double decay;
  double phi1;
  double phi2;
  double phi3;
  if (x < 0.25) {
    // The quotients cancel to nothing for small x, so the last one is summed as a series and the others follow from it.
    phi3 = 1.0 / 39916800.0;
    phi3 = 1.0 / 3628800.0 - x * phi3;
    phi3 = 1.0 / 362880.0 - x * phi3;
    phi3 = 1.0 / 40320.0 - x * phi3;
    phi3 = 1.0 / 5040.0 - x * phi3;
    phi3 = 1.0 / 720.0 - x * phi3;
    phi3 = 1.0 / 120.0 - x * phi3;
    phi3 = 1.0 / 24.0 - x * phi3;
    phi3 = 1.0 / 6.0 - x * phi3;
    phi2 = 0.5 - x * phi3;
    phi1 = 1.0 - x * phi2;
    decay = 1.0 - x * phi1;
  } else {
    decay = std::exp(-x);
    phi1 = (1.0 - decay) / x;
    phi2 = (1.0 - phi1) / x;
    phi3 = (0.5 - phi2) / x;
  }
  return {.decay = decay,
          .rate_0 = dt_s * (phi1 - phi2),
          .rate_1 = dt_s * phi2,
          .angle_p = dt_s * phi1,
          .angle_0 = dt_s * dt_s * (phi2 - phi3),
          .angle_1 = dt_s * dt_s * phi3};
}

}  // namespace fantail::identify
