// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "core/flight_plan.hpp"
#include "stability/speed_range.hpp"

// Gain schedules with factors (highest speed / speed)^exponent: the torque of canards grows with the square of the
// speed.
namespace fantail::stability {

/// Whether the speeds differ enough for gains to change with them.
[[nodiscard]] inline bool has_room_for_schedule(const SpeedRange& range) {
  return range.lowest_m_s > 0.0 && range.highest_m_s > 1.2 * range.lowest_m_s;
}

/// The powers of the speed with which a search lets the gains fall.
inline constexpr std::array schedule_exponents{0.5, 1.0, 1.5, 2.0};

[[nodiscard]] double factor_at_lowest_speed(double exponent, const SpeedRange& range);
/// The largest that a plan may have.
[[nodiscard]] double largest_schedule_factor();
/// Whether a plan may have the factor that this schedule needs at the lowest speed.
[[nodiscard]] bool is_within_plan(double exponent, const SpeedRange& range);

/// In as many rows as a plan may have; none for an exponent of zero, or without room.
[[nodiscard]] core::GainSchedulePlan gain_schedule(double exponent, const SpeedRange& range);

}  // namespace fantail::stability
