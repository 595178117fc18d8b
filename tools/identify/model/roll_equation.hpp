// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "sim/roll_plant.hpp"

// How a rocket rolls: once as an equation, once as its exact step.

namespace fantail::identify::model {

/// What of the rocket the equation needs. Only area times alpha and area times beta show in a transient.
struct Airframe {
  double inertia_kg_m2 = 0.0;      ///< I, about the long axis; above zero
  double reference_area_m2 = 0.0;  ///< A, above zero
};

/// The roll equation (Bryson et al. 2016, Eq 1-3):
///
///   I dp/dt = - 1/2 rho |v| A alpha p  +  1/2 rho v^2 A beta (u + u_d),      dphi/dt = p
///
///   phi    roll angle, rad, the integral of the rate and not wrapped;   p  roll rate, rad/s
///   u      mean deflection of the canards, rad: positive turns positively
///   u_d    disturbance, rad: the deflection that would turn the rocket as its crooked fins do
///   alpha  damping constant, m2, above zero;   beta  torque constant, m
///   rho    density of the air, kg/m3;          v     air speed, m/s
///
/// Divided by I, with the numbers that are looked for left outside:
///
///   dp/dt = - alpha damping_per_m2_s p  +  beta authority_per_m_s2 (u + u_d)
///
/// This type is what is left: the equation's coefficients in the air of one moment.
struct RollEquation {
  double damping_per_m2_s;    ///< 1/2 rho |v| A / I
  double authority_per_m_s2;  ///< 1/2 rho v^2 A / I

  /// How fast a roll rate dies out, 1/s.
  [[nodiscard]] double damping_rate_per_s(double alpha_m2) const { return alpha_m2 * damping_per_m2_s; }
  /// What a deflection u + u_d does, damping apart.
  [[nodiscard]] double acceleration_rad_s2(double beta_m, double deflection_rad) const {
    return authority_per_m_s2 * beta_m * deflection_rad;
  }
};

[[nodiscard]] inline RollEquation roll_equation(const Airframe& airframe, double density_kg_m3, double speed_m_s) {
  const double speed = std::abs(speed_m_s);
  const double damping_per_m2_s = 0.5 * density_kg_m3 * speed * airframe.reference_area_m2 / airframe.inertia_kg_m2;
  return {.damping_per_m2_s = damping_per_m2_s, .authority_per_m_s2 = damping_per_m2_s * speed};
}

// The exact step. With the damping rate a held over a step of length h and x = a h,
//
//   p' = e^-x p + integral of e^-a(h-t) g(t),     phi' = phi + h phi1(x) p + integral of (h-t) phi1(a(h-t)) g(t)
//
// for an acceleration g: exact for every h and every damping. Written with phi1 = (1 - e^-x) / x,
// phi2 = (1 - phi1) / x and phi3 = (1/2 - phi2) / x, which are summed as series where the quotients would cancel.

/// The step when the acceleration runs straight from g0 to g1 (rad/s2), as between two samples of a log.
struct RampStep {
  double decay;
  double rate_0;   ///< s
  double rate_1;   ///< s
  double angle_p;  ///< s
  double angle_0;  ///< s2
  double angle_1;  ///< s2

  // What of the step waits for the state, and what does not, are added up apart: states come one behind the other.
  // Inlined, because a state may be as many numbers as only some processors hand over in a register.
  template <typename State>
  [[nodiscard, gnu::always_inline]] State angle_change(const State& rate, const State& g0, const State& g1) const {
    return angle_p * rate + (angle_0 * g0 + angle_1 * g1);
  }
  template <typename State>
  [[nodiscard, gnu::always_inline]] State rate_after(const State& rate, const State& g0, const State& g1) const {
    return decay * rate + (rate_0 * g0 + rate_1 * g1);
  }
};

namespace detail {

[[nodiscard]] inline RampStep ramp_step(double decay, double phi1, double phi2, double phi3, double dt_s) {
  return {.decay = decay,
          .rate_0 = dt_s * (phi1 - phi2),
          .rate_1 = dt_s * phi2,
          .angle_p = dt_s * phi1,
          .angle_0 = dt_s * dt_s * (phi2 - phi3),
          .angle_1 = dt_s * dt_s * phi3};
}

}  // namespace detail

/// Below this x the quotients of ramp_step() cancel to nothing.
inline constexpr double small_damping = 0.25;

/// For small x. Without branches, so that a compiler makes several steps at a time.
[[nodiscard]] inline RampStep small_ramp_step(double x, double dt_s) {
  // phi3 is summed as a series and the others follow from it.
  double phi3 = 1.0 / 3628800.0 - x * (1.0 / 39916800.0);
  phi3 = 1.0 / 362880.0 - x * phi3;
  phi3 = 1.0 / 40320.0 - x * phi3;
  phi3 = 1.0 / 5040.0 - x * phi3;
  phi3 = 1.0 / 720.0 - x * phi3;
  phi3 = 1.0 / 120.0 - x * phi3;
  phi3 = 1.0 / 24.0 - x * phi3;
  phi3 = 1.0 / 6.0 - x * phi3;
  const double phi2 = 0.5 - x * phi3;
  const double phi1 = 1.0 - x * phi2;
  return detail::ramp_step(1.0 - x * phi1, phi1, phi2, phi3, dt_s);
}

/// damping_rate_per_s and dt_s not negative.
[[nodiscard]] inline RampStep ramp_step(double damping_rate_per_s, double dt_s) {
  const double x = damping_rate_per_s * dt_s;
  if (x < small_damping) {
    return small_ramp_step(x, dt_s);
  }
  const double decay = std::exp(-x);
  const double phi1 = (1.0 - decay) / x;
  const double phi2 = (1.0 - phi1) / x;
  const double phi3 = (0.5 - phi2) / x;
  return detail::ramp_step(decay, phi1, phi2, phi3, dt_s);
}

/// The step when air and deflection are held, as over a period of the flight controller. It is driven by
/// x = beta (u + u_d), in m, so that one step of an alpha serves every beta.
struct HeldStep {
  double decay;
  double angle_p_s;
  double rate_gain;   ///< 1/(m s)
  double angle_gain;  ///< 1/m

  [[nodiscard]] double angle_change(double rate, double x) const { return angle_p_s * rate + angle_gain * x; }
  [[nodiscard]] double rate_after(double rate, double x) const { return decay * rate + rate_gain * x; }
};

/// A held step and how it changes with alpha: the derivative of each of its numbers.
struct HeldStepAndSlope {
  HeldStep step;
  HeldStep by_alpha;
};

namespace detail {

[[nodiscard]] inline HeldStep held_step(const RollEquation& equation, const sim::RollTransition& exact) {
  return {.decay = exact.decay,
          .angle_p_s = exact.c1_s,
          .rate_gain = equation.authority_per_m_s2 * exact.c1_s,
          .angle_gain = equation.authority_per_m_s2 * exact.c2_s2};
}

}  // namespace detail

/// The simulated world's own exact step: a rocket flown there is stepped here to the last digit. dt_s not negative.
[[nodiscard]] inline HeldStep held_step(const RollEquation& equation, double alpha_m2, double dt_s) {
  return detail::held_step(equation, sim::roll_transition(equation.damping_rate_per_s(alpha_m2), dt_s));
}

[[nodiscard]] inline HeldStepAndSlope held_step_and_slope(const RollEquation& equation, double alpha_m2, double dt_s) {
  const sim::RollTransition exact = sim::roll_transition(equation.damping_rate_per_s(alpha_m2), dt_s);
  const HeldStep step = detail::held_step(equation, exact);
  if (dt_s <= 0.0) {
    return {.step = step, .by_alpha = {}};
  }
  // By x, phi1 has the slope phi2 - phi1 and phi2 the slope 2 phi3 - phi2: no difference of nearly equal numbers but in
  // phi3.
  const double x = equation.damping_per_m2_s * alpha_m2 * dt_s;
  const double phi1 = exact.c1_s / dt_s;
  const double phi2 = exact.c2_s2 / (dt_s * dt_s);
  const double phi3 =
      x < 0.01 ? 1.0 / 6 - x * (1.0 / 24 - x * (1.0 / 120 - x * (1.0 / 720 - x * (1.0 / 5040)))) : (0.5 - phi2) / x;
  const double x_by_alpha = equation.damping_per_m2_s * dt_s;
  const sim::RollTransition slope{.decay = -x_by_alpha * exact.decay,
                                  .c1_s = x_by_alpha * dt_s * (phi2 - phi1),
                                  .c2_s2 = x_by_alpha * dt_s * dt_s * (2.0 * phi3 - phi2)};
  return {.step = step, .by_alpha = detail::held_step(equation, slope)};
}

}  // namespace fantail::identify::model
