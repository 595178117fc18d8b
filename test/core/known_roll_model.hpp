// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"

namespace fantail::core {

/// For a law that observes: about that of the second launch.
inline constexpr RollModelPlan known_roll_model{.roll_inertia_kg_m2 = 0.004F,
                                                .reference_area_m2 = 5e-5F,
                                                .damping_m2 = 23.0F,
                                                .torque_m = 9.0F,
                                                .density_kg_m3 = 1.2F};

/// The same rocket: Euler's steps of the roll equation in double precision, much finer than a tick.
struct RollingRocket {
  double rate_rad_s = 0.0;
  void turn(double canard_rad, double offset_rad, double speed_m_s) {
    const double common = 1.2 * 5e-5 * speed_m_s / (2.0 * 0.004);
    for (int i = 0; i < 100; ++i) {
      rate_rad_s += 1e-5 * (common * speed_m_s * 9.0 * (canard_rad + offset_rad) - common * 23.0 * rate_rad_s);
    }
  }
};

}  // namespace fantail::core
