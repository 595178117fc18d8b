// SPDX-License-Identifier: MIT
#include "airframe/model/fin_set.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace fantail::airframe::model {
namespace {

using sim::Geometry;
using std::numbers::pi;

double square(double x) { return x * x; }

double area_m2(const Geometry::FinSet& fins) { return 0.5 * fins.span_m * (fins.root_chord_m + fins.tip_chord_m); }

double one_fin_area_m2(const Geometry::FinSet& fins) {
  const double middle_sweep_m = fins.sweep_m + 0.5 * (fins.tip_chord_m - fins.root_chord_m);
  const double middle_line_m = std::hypot(fins.span_m, middle_sweep_m);
  return 2.0 * pi * square(fins.span_m) / (1.0 + std::sqrt(1.0 + square(fins.span_m * middle_line_m / area_m2(fins))));
}

/// Integral of chord times the square of the distance from the long axis, over the span.
double second_moment_m4(const Geometry::FinSet& fins, double r) {
  const double s = fins.span_m;
  const double root = fins.root_chord_m;
  const double tip = fins.tip_chord_m;
  return ((root + 3.0 * tip) * s * s * s + 4.0 * (root + 2.0 * tip) * r * s * s + 6.0 * (root + tip) * s * r * r) /
         12.0;
}

/// Lift of turned fins on a body that is not turned, over that of the fins alone (Barrowman after NACA 1307, Eq 19), of
/// the ratio of tip radius to body radius.
double turned_fin_factor(double tau) {
  const double t2 = tau * tau;
  const double angle = std::asin((t2 - 1.0) / (t2 + 1.0));
  const double common = square(t2 + 1.0) / (t2 * square(tau - 1.0));
  const double edge = (tau + 1.0) / (tau * (tau - 1.0));
  return (0.25 * square(pi * (tau + 1.0) / tau) + pi * common * angle - 2.0 * pi * edge + common * angle * angle -
          4.0 * edge * angle + 8.0 / square(tau - 1.0) * std::log((t2 + 1.0) / (2.0 * tau))) /
         (pi * pi);
}

/// What the body adds to the damping of rolling fins (Barrowman), of the same ratio and the taper.
double rolling_fin_factor(double tau, double taper) {
  return 1.0 + ((tau - taper) / tau - (1.0 - taper) / (tau - 1.0) * std::log(tau)) /
                   (0.5 * (tau + 1.0) * (tau - taper) - (1.0 - taper) * (tau * tau * tau - 1.0) / (3.0 * (tau - 1.0)));
}

/// More than four fins disturb each other.
double crowding(int count) {
  constexpr std::array<double, 4> of_five_to_eight{2.37 / 2.5, 2.74 / 3.0, 2.99 / 3.5, 3.24 / 4.0};
  return count <= 4 ? 1.0 : of_five_to_eight[static_cast<std::size_t>(count - 5)];
}

}  // namespace

FinForces fin_forces(const Geometry::FinSet& fins, double body_radius_m) {
  const double root = fins.root_chord_m;
  const double tip = fins.tip_chord_m;
  const double chords = root + tip;
  const double count = fins.count;
  const double tau = (fins.span_m + body_radius_m) / body_radius_m;

  FinForces forces;
  forces.one_fin_area_m2 = one_fin_area_m2(fins);
  forces.slope_area_m2 = 0.5 * count * crowding(fins.count) * (1.0 + 1.0 / tau) * forces.one_fin_area_m2;
  forces.mean_chord_m = 2.0 / 3.0 * (chords - root * tip / chords);
  forces.mean_chord_front_m = fins.sweep_m / 3.0 * (root + 2.0 * tip) / chords;
  forces.position_m = fins.position_m + forces.mean_chord_front_m + 0.25 * forces.mean_chord_m;
  forces.arm_m = body_radius_m + fins.span_m / 3.0 * (root + 2.0 * tip) / chords;
  forces.roll_torque_m3 = count * turned_fin_factor(tau) * forces.one_fin_area_m2 * forces.arm_m;
  forces.roll_damping_m4 = count * rolling_fin_factor(tau, tip / root) * forces.one_fin_area_m2 / area_m2(fins) *
                           second_moment_m4(fins, body_radius_m);
  return forces;
}

}  // namespace fantail::airframe::model
