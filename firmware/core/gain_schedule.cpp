// SPDX-License-Identifier: MIT
#include "core/gain_schedule.hpp"

#include <cstddef>
#include <limits>

namespace fantail::core {

GainSchedule::GainSchedule(const GainSchedulePlan& plan) : is_there_{plan.speeds_count > 0} {
  const std::size_t rows = plan.speeds_count;
  const std::size_t first = most_schedule_rows - rows;
  lines_[first] = {.from_m_s = -std::numeric_limits<float>::infinity(), .at_zero = plan.factors[0], .per_m_s = 0.0F};
  for (std::size_t row = 0; row < rows; ++row) {
    const float from_m_s = plan.speeds_m_s[row];
    const bool is_last = row + 1 == rows;
    const float slope =
        is_last ? 0.0F : (plan.factors[row + 1] - plan.factors[row]) / (plan.speeds_m_s[row + 1] - from_m_s);
    lines_[first + 1 + row] = {.from_m_s = from_m_s, .at_zero = plan.factors[row] - slope * from_m_s, .per_m_s = slope};
  }
}

}  // namespace fantail::core
