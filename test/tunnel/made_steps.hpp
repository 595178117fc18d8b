// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/roll_plant.hpp"
#include "tunnel/made_logs.hpp"
#include "tunnel/steps.hpp"

namespace fantail::tunnel {

inline constexpr identify::model::Airframe tasha{.inertia_kg_m2 = 0.00393, .reference_area_m2 = 5.0265e-5};

struct Planted {
  double alpha_m2;
  double beta_m;
  double offset_deg;
};

// A run at 100 Hz and 22 m/s whose reference goes between 0 and 45 deg every `half_wave_s`; in each step another rocket
// rolls. Where the canards go until the next sample follows from this one, so that they run straight between samples,
// as the model takes them to.
inline logs::RollLog made_run(const std::vector<Planted>& rockets, double half_wave_s = 6.0) {
  logs::RollLog log;
  log.name = "run.csv";
  constexpr double dt_s = 0.01;
  sim::RollState state;
  double canard = 0.0;
  for (int i = -100; i < std::lround(half_wave_s / dt_s) * static_cast<long>(rockets.size()); ++i) {
    const double t = dt_s * i;
    const auto step = static_cast<std::size_t>(std::max(t / half_wave_s + 1e-9, 0.0));
    const double reference = i < 0 ? 0.0 : step % 2 == 0 ? 45.0 * degree : 0.0;
    log.time_s.push_back(t);
    log.roll_angle_rad.push_back(state.angle_rad);
    log.roll_rate_rad_s.push_back(state.rate_rad_s);
    log.reference_rad.push_back(reference);
    log.canard_rad.push_back(canard);
    log.phase.push_back(i < 0 ? core::Phase::armed : core::Phase::controlling);
    if (i >= 0) {
      const sim::RollPlant plant{.inertia_kg_m2 = tasha.inertia_kg_m2,
                                 .reference_area_m2 = tasha.reference_area_m2,
                                 .damping_m2 = rockets[step].alpha_m2,
                                 .torque_m = rockets[step].beta_m};
      const double next = 0.5 * (reference - state.angle_rad) - 0.05 * state.rate_rad_s;
      for (int k = 0; k < 10; ++k) {
        const double between = canard + (next - canard) * (k + 0.5) / 10.0;
        state = plant.step(state, 1.2, 22.0, between + rockets[step].offset_deg * degree, dt_s / 10.0);
      }
      canard = next;
    }
  }
  return log;
}

inline StepOptions at_22_m_s() {
  StepOptions options;
  options.record.speed_m_s = 22.0;
  options.record.density_kg_m3 = 1.2;
  return options;
}

inline const std::vector<Planted> three_rockets{{13.0, 10.5, -6.0}, {22.0, 9.0, -5.0}, {25.0, 12.0, -7.0}};

}  // namespace fantail::tunnel
