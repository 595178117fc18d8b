// SPDX-License-Identifier: MIT
#pragma once

#include "identify/model/roll_model.hpp"
#include "paper/closed_loop.hpp"

namespace fantail::paper {

/// What a log of this run would hold from `from_s` to `to_s`, a sample every `every_ms`, without noise.
[[nodiscard]] identify::model::Record flown_record(const Loop& loop, double from_s, double to_s, int every_ms);

[[nodiscard]] inline identify::model::Airframe airframe(const Loop& loop) {
  return {.inertia_kg_m2 = loop.plant.inertia_kg_m2, .reference_area_m2 = loop.plant.reference_area_m2};
}

/// One of the eight published tunnel steps, as identified.
struct TunnelStep {
  int step;
  double alpha_m2;
  double beta_m;
  double disturbance_begin_deg;
  double disturbance_end_deg;
  double mean_abs_angle_error_deg;
  double mean_abs_rate_error_deg_s;
};

/// Table 2 with the two minus signs that its print lost.
inline constexpr TunnelStep table_2[] = {
    {1, 13, 10.5, -5.59, -7.71, 1.64, 6.23}, {2, 15, 6.5, -5.82, -6.10, 0.70, 2.38},
    {3, 22, 10.5, -6.04, -6.35, 1.13, 4.40}, {4, 15, 6.0, -4.18, -7.16, 0.42, 2.08},
    {5, 25, 12.5, -5.90, -6.51, 0.82, 2.92}, {6, 23, 10.5, -5.12, -6.25, 0.26, 1.66},
    {7, 15, 10.5, -6.11, -7.41, 1.43, 5.84}, {8, 27, 10.0, -5.47, -5.44, 0.60, 2.66}};

/// The tunnel run of such a step: 22 m/s, 0 to 45 degrees, from rest, the canards following at once.
[[nodiscard]] Loop tunnel_loop(const TunnelStep& row);

}  // namespace fantail::paper
