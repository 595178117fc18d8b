// SPDX-License-Identifier: MIT
#pragma once

#include <deque>

namespace fantail::sim {

/// The vortices of the canards turn the flow at the fins behind them, which take back a share of the roll torque:
/// with more than all of it the rocket rolls against its canards. J. N. Nielsen, Missile Aerodynamics (1960),
/// tells how such interference follows from the spans; here it is a coefficient.
///
/// The fins meet the air that was at the canards a distance before: at a steady speed, distance / speed later. Air that
/// no canard has met yet is not turned.
class FinWash {
 public:
  /// Share from zero on (zero: no wash), distance not negative.
  FinWash(double share, double distance_m)
      : share_{share}, distance_m_{distance_m}, least_between_m_{distance_m / 512.0} {}

  /// One step in which the canards' mean torque angle was this, and so much air passed along the rocket; air that comes
  /// from behind, below zero, leaves everything as it is. Gives the angle at the canards that would make the torque
  /// that the fins took back, mean of the step.
  double step(double canard_rad, double path_m) { return share_ == 0.0 ? 0.0 : moved_on(canard_rad, path_m); }

  /// Of the last step.
  [[nodiscard]] double angle_rad() const { return angle_rad_; }

 private:
  /// The integral of the canards' angle over the path of the air; linear in between.
  struct Knot {
    double path_m;
    double sum_m_rad;
  };
  double moved_on(double canard_rad, double path_m);
  double sum_at(double path_m);

  double share_;
  double distance_m_;
  double least_between_m_;  ///< nearer knots are one: slow air would make any number of them
  std::deque<Knot> knots_;  ///< those that the fins have still to meet, and the last that they met
  Knot now_{};
  double met_m_rad_ = 0.0;  ///< the sum at the fins
  double angle_rad_ = 0.0;
};

}  // namespace fantail::sim
