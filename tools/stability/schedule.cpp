// SPDX-License-Identifier: MIT
#include "stability/schedule.hpp"

#include <cmath>
#include <cstddef>

namespace fantail::stability {

double factor_at_lowest_speed(double exponent, const SpeedRange& range) {
  return std::pow(range.highest_m_s / range.lowest_m_s, exponent);
}

double largest_schedule_factor() { return plan_range("gain_schedule", "factors").maximum; }

bool is_within_plan(double exponent, const SpeedRange& range) {
  return factor_at_lowest_speed(exponent, range) <= largest_schedule_factor();
}

/// Speeds in equal ratios: there the torque of the canards changes equally much from row to row.
core::GainSchedulePlan gain_schedule(double exponent, const SpeedRange& range) {
  core::GainSchedulePlan plan{};
  if (exponent == 0.0 || !has_room_for_schedule(range)) {
    return plan;
  }
  constexpr std::size_t rows = core::most_schedule_rows;
  plan.speeds_count = rows;
  plan.factors_count = rows;
  for (std::size_t row = 0; row < rows; ++row) {
    const double share = static_cast<double>(row) / static_cast<double>(rows - 1);
    const double speed_m_s = range.lowest_m_s * std::pow(range.highest_m_s / range.lowest_m_s, share);
    const double factor = std::pow(range.highest_m_s / speed_m_s, exponent);
    plan.speeds_m_s[row] = static_cast<float>(std::round(10.0 * speed_m_s) / 10.0);
    plan.factors[row] = static_cast<float>(std::round(100.0 * factor) / 100.0);
  }
  return plan;
}

}  // namespace fantail::stability
