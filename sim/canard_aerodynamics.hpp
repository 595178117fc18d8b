// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace fantail::sim {

/// What the air does to the canards beyond a torque in proportion to their angle. Every effect is off while its field
/// is empty or zero.
struct CanardAerodynamics {
  /// The lift of a canard is in proportion to its effective angle up to this one, and stays what it is there beyond;
  /// above zero. It stays, because canards are thin plates of a low aspect ratio: their side edges keep the flow
  /// attached, and the lift falls little behind its maximum (S. F. Hoerner and H. V. Borst, Fluid-Dynamic Lift, 1985:
  /// low aspect ratios). A canard of a high aspect ratio would lose lift there.
  std::optional<double> stall_rad{};
  /// From the long axis to where a canard lifts: a roll rate p makes the angle p r / v at it. Empty: that is left out
  /// of the effective angle. Not more than alpha / beta, at which the canards would be all of the roll damping.
  std::optional<double> arm_m{};
  double wash = 0.0;             ///< share of the canards' roll torque that the fins take back, see FinWash; 0 to 2
  double wash_distance_m = 0.0;  ///< from the canards back to the fins, not negative
  /// Hinge moment of a canard over 1/2 rho v^2 and its effective angle, see ShaftLoad. Empty: it loads no servo. Stall
  /// is not in it: where lift stays, its centre moves back.
  std::optional<double> hinge_moment_m3{};
  /// Side force of one canard over 1/2 rho v^2 and its angle. Empty: canards that do not stand alike push the rocket to
  /// no side. In six degrees of freedom only.
  std::optional<double> side_area_m2{};
  std::optional<double> position_m{};  ///< where they push, from the tip of the nose; given together with side_area_m2
};

/// The air in which the canards turn.
struct CanardFlow {
  double density_kg_m3 = 0.0;
  double speed_m_s = 0.0;  ///< along the axis
  double roll_rate_rad_s = 0.0;
};

/// What the fins leave of a roll torque of the canards in the end; below zero the rocket rolls against its canards.
[[nodiscard]] inline double left_by_fins(const CanardAerodynamics& air) { return 1.0 - air.wash; }

/// Of a canard at this effective angle; as an angle that would make the lift if it never stalled.
[[nodiscard]] inline double lift_angle_rad(const CanardAerodynamics& air, double effective_rad) {
  return air.stall_rad ? std::clamp(effective_rad, -*air.stall_rad, *air.stall_rad) : effective_rad;
}

/// The angle that a roll rate makes at the canards, in the sense of positive roll moment; zero in still air.
[[nodiscard]] inline double angle_of_roll_rad(const CanardAerodynamics& air, double roll_rate_rad_s, double speed_m_s) {
  constexpr double still_m_s = 1e-3;
  const double speed = std::abs(speed_m_s);
  return air.arm_m && speed > still_m_s ? -roll_rate_rad_s * *air.arm_m / speed : 0.0;
}

/// What the roll plant takes for the deflection of one canard: `deflection_rad`, from its trim, unless it stalls. Its
/// part of the roll damping is in alpha, which knows no stall; so here it is taken off the lift again, and a stalled
/// canard damps no more.
[[nodiscard]] inline double torque_angle_rad(const CanardAerodynamics& air, double deflection_rad, double of_roll_rad) {
  if (!air.stall_rad) {
    return deflection_rad;
  }
  const double effective_rad = deflection_rad + of_roll_rad;
  const double lift_rad = lift_angle_rad(air, effective_rad);
  return lift_rad == effective_rad ? deflection_rad : lift_rad - of_roll_rad;
}

}  // namespace fantail::sim
