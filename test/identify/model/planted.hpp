// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "identify/model/roll_model.hpp"

namespace fantail::identify::model {

inline constexpr double radians_per_degree = 0.017453292519943295;

inline constexpr Airframe tasha{.inertia_kg_m2 = 0.00393, .reference_area_m2 = 5.0265e-5};

/// A record whose truth is known: the roll of a planted model, stepped by this file's own integrator (a thousand
/// midpoint steps a second or more), under canards that move in several sines at once.
struct Planting {
  double alpha_m2 = 20.0;
  double beta_m = 9.0;
  NodeTimes node_time_s{0.0};
  std::vector<double> node_deg{-5.0};
  double seconds = 4.0;
  double sample_hz = 100.0;
  double speed_begin_m_s = 40.0;  ///< changes evenly
  double speed_end_m_s = 60.0;
  double canard_amplitude_deg = 4.0;
  double start_angle_deg = 3.0;
  double start_rate_deg_s = -20.0;
};
[[nodiscard]] Record planted_record(const Planting& planting);

[[nodiscard]] double planted_disturbance_rad(const Planting& planting, double time_s);

/// Adds angle noise of this standard deviation that is forgotten with this time constant (0: white), and white rate
/// noise.
struct Noise {
  double angle_deg = 0.3;
  double correlation_s = 0.0;
  double rate_deg_s = 1.0;
};
void add_noise(Record& record, const Noise& noise, std::uint64_t seed);

}  // namespace fantail::identify::model
