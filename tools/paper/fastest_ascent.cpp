// SPDX-License-Identifier: MIT
#include "paper/fastest_ascent.hpp"

#include <algorithm>
#include <cmath>

#include "sim/units.hpp"

namespace fantail::paper {

double least_time_to_apogee_s(double height_m, double top_speed_m_s, const Coasting& coasting) {
  constexpr double g = sim::gravity_m_s2;
  // The speed at which drag equals weight; the coast's closed forms are written in it.
  const double terminal_m_s = std::sqrt(g / coasting.drag_per_mass_1_m);
  const double scale_m = terminal_m_s * terminal_m_s / (2.0 * g);
  const double speed_to_coast_all_m_s = terminal_m_s * std::sqrt(std::expm1(height_m / scale_m));
  const double speed_m_s = std::min(top_speed_m_s, speed_to_coast_all_m_s);
  const double ratio = speed_m_s / terminal_m_s;
  const double coast_m = scale_m * std::log1p(ratio * ratio);
  const double coast_s = terminal_m_s / g * std::atan(ratio);
  return coast_s + (height_m - coast_m) / speed_m_s;
}

}  // namespace fantail::paper
