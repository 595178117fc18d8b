// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace fantail::identify {

/// What one step of length dt does to rate p and angle phi when the roll acceleration runs straight from g0 to g1:
///   p' = decay p + rate_0 g0 + rate_1 g1,   phi' = phi + angle_p p + angle_0 g0 + angle_1 g1.
/// Exact for every step and every damping (the plant of Eq 2-3 with held damping).
template <typename Number>
struct RampTransitionOf {
  Number decay;
  Number rate_0;
  Number rate_1;
  Number angle_p;
  Number angle_0;
  Number angle_1;
};
using RampTransition = RampTransitionOf<double>;

/// Below this damping in a step the quotients of ramp_transition() cancel to nothing.
inline constexpr double small_ramp_damping = 0.25;

/// damping = damping rate times dt, small. Also for arrays of numbers, several steps at a time.
template <typename Number>
[[nodiscard]] inline RampTransitionOf<Number> small_ramp_transition(const Number& damping, const Number& dt_s) {
  // phi3 is summed as a series and the others follow from it.
  Number phi3 = 1.0 / 3628800.0 - damping * (1.0 / 39916800.0);
  phi3 = 1.0 / 362880.0 - damping * phi3;
  phi3 = 1.0 / 40320.0 - damping * phi3;
  phi3 = 1.0 / 5040.0 - damping * phi3;
  phi3 = 1.0 / 720.0 - damping * phi3;
  phi3 = 1.0 / 120.0 - damping * phi3;
  phi3 = 1.0 / 24.0 - damping * phi3;
  phi3 = 1.0 / 6.0 - damping * phi3;
  const Number phi2 = 0.5 - damping * phi3;
  const Number phi1 = 1.0 - damping * phi2;
  return {.decay = 1.0 - damping * phi1,
          .rate_0 = dt_s * (phi1 - phi2),
          .rate_1 = dt_s * phi2,
          .angle_p = dt_s * phi1,
          .angle_0 = dt_s * dt_s * (phi2 - phi3),
          .angle_1 = dt_s * dt_s * phi3};
}

/// damping_rate_per_s and dt_s not negative.
[[nodiscard]] inline RampTransition ramp_transition(double damping_rate_per_s, double dt_s) {
  // phi1 = (1 - e^-x) / x and so on, each phi_k = (1 / k! - phi_k+1 ...) / x of the one before.
  const double x = damping_rate_per_s * dt_s;
  if (x < small_ramp_damping) {
    return small_ramp_transition(x, dt_s);
  }
  const double decay = std::exp(-x);
  const double phi1 = (1.0 - decay) / x;
  const double phi2 = (1.0 - phi1) / x;
  const double phi3 = (0.5 - phi2) / x;
  return {.decay = decay,
          .rate_0 = dt_s * (phi1 - phi2),
          .rate_1 = dt_s * phi2,
          .angle_p = dt_s * phi1,
          .angle_0 = dt_s * dt_s * (phi2 - phi3),
          .angle_1 = dt_s * dt_s * phi3};
}

}  // namespace fantail::identify
