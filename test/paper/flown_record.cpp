// SPDX-License-Identifier: MIT
#include "paper/flown_record.hpp"

#include <cmath>

#include "core/flight_plan_fields.hpp"

namespace fantail::paper {

identify::model::Record flown_record(const Loop& loop, double from_s, double to_s, int every_ms) {
  const std::vector<Point> points = run(loop, to_s);
  identify::model::Record record;
  record.window = "flown";
  record.window_begin_s = from_s;
  const auto first = static_cast<std::size_t>(std::lround(from_s * 1e3));
  for (std::size_t i = first; i < points.size(); i += static_cast<std::size_t>(every_ms)) {
    const Point& point = points[i];
    record.time_s.push_back(point.time_s - from_s);
    record.roll_angle_rad.push_back(point.angle_deg * radians_per_degree);
    record.roll_rate_rad_s.push_back(point.rate_deg_s * radians_per_degree);
    record.canard_rad.push_back(point.canard_deg * radians_per_degree);
    record.speed_m_s.push_back(loop.speed_m_s(point.time_s));
    record.density_kg_m3.push_back(density_kg_m3);
    record.offset_estimate_rad.push_back(point.offset_estimate_deg * radians_per_degree);
    record.law_speed_m_s.push_back(record.speed_m_s.back());
  }
  return record;
}

Loop tunnel_loop(const TunnelStep& row) {
  const double d = radians_per_degree;
  return {.plant = {.inertia_kg_m2 = 0.00393,
                    .reference_area_m2 = reference_area_m2,
                    .damping_m2 = row.alpha_m2,
                    .torque_m = row.beta_m},
          .controller = gains(0.5, 0.05, 9),
          .reference = hold(45),
          .excitation = core::default_plan().excitation,
          .disturbance = sim::Disturbance{{{0.0, row.disturbance_begin_deg * d}, {5.0, row.disturbance_end_deg * d}}},
          .speed_m_s = [](double) { return 22.0; },
          .control_from_s = 0.0,
          .servo_lag_s = {},
          .start = {}};
}

}  // namespace fantail::paper
