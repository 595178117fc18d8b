// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "core/flight_plan.hpp"

namespace fantail::core {

/// The factor on all gains of the law at this speed: linear between the rows of the schedule, and beyond its ends as at
/// the end. 1 without a schedule. A canard's torque grows with the square of the speed, so where the speed is only
/// known to be at least this, the last row counts: too weak a loop rests further off, too strong a one swings.
class GainSchedule {
 public:
  /// `plan` has passed validate().
  [[gnu::cold]] explicit GainSchedule(const GainSchedulePlan& plan);

  /// A speed below the first row, and a negative one, counts as the first row; a NaN as the last.
  [[nodiscard]] float factor(float speed_m_s, bool speed_is_lower_bound) const {
    if (!is_there_) {
      return 1.0F;
    }
    const Line* line = &lines_.back();
    if (speed_is_lower_bound || !(speed_m_s < line->from_m_s)) {
      return line->at_zero;
    }
    do {
      --line;
    } while (speed_m_s < line->from_m_s);
    return line->at_zero + line->per_m_s * speed_m_s;
  }

 private:
  struct Line {
    float from_m_s;
    float at_zero;
    float per_m_s;
  };
  bool is_there_;
  /// By increasing speed, up to the end of the array: a level one from minus infinity on, one from each row, and the
  /// last one level again.
  std::array<Line, most_schedule_rows + 1> lines_{};
};

/// The same for a single question: the schedule is made anew at each call. `plan` has passed validate().
[[nodiscard]] inline float gain_factor(const GainSchedulePlan& plan, float speed_m_s, bool speed_is_lower_bound) {
  return GainSchedule{plan}.factor(speed_m_s, speed_is_lower_bound);
}

}  // namespace fantail::core
