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

}  // namespace fantail::core
