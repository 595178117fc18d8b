// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"

namespace fantail::core {

/// The factor on all gains of the law at this speed: linear between the rows of the schedule, and beyond its ends as at
/// the end. 1 without a schedule. A canard's torque grows with the square of the speed, so where the speed is only
/// known to be at least this, the last row counts: too weak a loop rests further off, too strong a one swings.
[[nodiscard]] float gain_factor(const GainSchedulePlan& plan, float speed_m_s, bool speed_is_lower_bound);

}  // namespace fantail::core
