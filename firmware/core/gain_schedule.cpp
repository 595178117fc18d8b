// SPDX-License-Identifier: MIT
#include "core/gain_schedule.hpp"

#include <cstddef>

namespace fantail::core {

float gain_factor(const GainSchedulePlan& plan, float speed_m_s, bool speed_is_lower_bound) {
  const std::size_t rows = plan.speeds_count;
  if (rows == 0) {
    return 1.0F;
  }
  std::size_t next = 0;
  while (next < rows && (speed_is_lower_bound || !(speed_m_s < plan.speeds_m_s[next]))) {
    ++next;
  }
  if (next == 0 || next == rows) {
    return plan.factors[next == 0 ? 0 : rows - 1];
  }
  const float from_m_s = plan.speeds_m_s[next - 1];
  const float share = (speed_m_s - from_m_s) / (plan.speeds_m_s[next] - from_m_s);
  const float first = plan.factors[next - 1];
  return first + share * (plan.factors[next] - first);
}

}  // namespace fantail::core
