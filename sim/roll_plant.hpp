// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "sim/elementary.hpp"

namespace fantail::sim {

struct RollState {
  double angle_rad = 0.0;  ///< the integral of the rate, not wrapped
  double rate_rad_s = 0.0;
};

/// What one step of length dt does to rate p and angle phi under a constant roll acceleration g, damping apart:
///   p' = decay p + c1 g,   phi' = phi + c1 p + c2 g.
struct RollTransition {
  double decay;
  double c1_s;
  double c2_s2;
};

/// Exact to a few units in the last place for every damping rate (zero too) and every step from zero on.
[[nodiscard]] inline RollTransition roll_transition(double damping_rate_per_s, double dt_s) {
  const double x = damping_rate_per_s * dt_s;
  if (std::abs(x) < 0.0625) {
    // (e^-x - 1 + x) / x^2 as its series: the quotient cancels to nothing for small x and is 0/0 without damping. Nine
    // terms leave less than half a unit in the last place up to the limit. Pairs keep the chain of operations short.
    const double x2 = x * x;
    const double x4 = x2 * x2;
    const double low = (1.0 / 2 - x * (1.0 / 6)) + x2 * (1.0 / 24 - x * (1.0 / 120));
    const double high = (1.0 / 720 - x * (1.0 / 5040)) + x2 * (1.0 / 40320 - x * (1.0 / 362880));
    const double phi2 = low + x4 * (high + x4 * (1.0 / 3628800));
    const double phi1 = 1.0 - x * phi2;
    return {.decay = 1.0 - x * phi1, .c1_s = dt_s * phi1, .c2_s2 = dt_s * dt_s * phi2};
  }
  if (std::abs(x) < 1.0) {
    // The same series, longer: only stiff plants and long steps come here.
    double phi2 = 0.0;
    for (int n = 20; n >= 2; --n) {
      phi2 = (1.0 - x * phi2) / static_cast<double>(n);
    }
    const double phi1 = 1.0 - x * phi2;
    return {.decay = 1.0 - x * phi1, .c1_s = dt_s * phi1, .c2_s2 = dt_s * dt_s * phi2};
  }
  const double decay = exponential(-x);
  const double c1_s = (1.0 - decay) / damping_rate_per_s;
  return {.decay = decay, .c1_s = c1_s, .c2_s2 = (dt_s - c1_s) / damping_rate_per_s};
}

/// How a rocket rolls (Bryson et al. 2016, Eq 1-3):
///   I dp/dt = -1/2 rho |v| A alpha p + 1/2 rho v^2 A beta u,   dphi/dt = p,
/// u being the canards' deflection plus the equivalent one of the disturbance. Only A alpha and A beta matter in a
/// transient, and steady states do not see A at all. The torque goes with v^2 as printed: it keeps its sense in air
/// from behind, which the model has only in the moment after apogee.
struct RollPlant {
  double inertia_kg_m2 = 0.0;      ///< I, above zero
  double reference_area_m2 = 0.0;  ///< A
  double damping_m2 = 0.0;         ///< alpha, not negative
  double torque_m = 0.0;           ///< beta

  /// How fast a roll rate dies out: the inverse of the roll time constant.
  [[nodiscard]] double damping_rate_per_s(double density_kg_m3, double speed_m_s) const {
    return per_inertia(density_kg_m3, std::abs(speed_m_s)) * damping_m2;
  }

  /// Roll acceleration per radian of deflection.
  [[nodiscard]] double authority_per_s2(double density_kg_m3, double speed_m_s) const {
    return per_inertia(density_kg_m3, std::abs(speed_m_s)) * (std::abs(speed_m_s) * torque_m);
  }

  /// The exact solution after `dt_s` (not negative) with density, speed and deflection held: no step is too long for it
  /// and no damping too stiff.
  [[nodiscard]] RollState step(const RollState& state, double density_kg_m3, double speed_m_s, double deflection_rad,
                               double dt_s) const;

 private:
  [[nodiscard]] double per_inertia(double density_kg_m3, double speed_m_s) const {
    return 0.5 * density_kg_m3 * speed_m_s * reference_area_m2 / inertia_kg_m2;
  }
};

inline RollState RollPlant::step(const RollState& state, double density_kg_m3, double speed_m_s, double deflection_rad,
                                 double dt_s) const {
  const double speed = std::abs(speed_m_s);
  const double common = per_inertia(density_kg_m3, speed);
  const double acceleration_rad_s2 = common * (speed * torque_m) * deflection_rad;
  const auto [decay, c1_s, c2_s2] = roll_transition(common * damping_m2, dt_s);
  return {.angle_rad = state.angle_rad + (c1_s * state.rate_rad_s + c2_s2 * acceleration_rad_s2),
          .rate_rad_s = decay * state.rate_rad_s + c1_s * acceleration_rad_s2};
}

}  // namespace fantail::sim
