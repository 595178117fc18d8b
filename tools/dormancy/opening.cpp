// SPDX-License-Identifier: MIT
#include "dormancy/opening.hpp"

#include <cmath>

namespace fantail::dormancy {

void OpeningWatch::add(const flight::Row& row, const flight::Flight& so_far) {
  zero_.add(row);
  const bool controls = row.phase == core::Phase::controlling;
  if (!opening_ && controls) {
    opening_ = Opening{.time_s = row.time_s,
                       .was_waited_for = so_far.events.dormant_s.has_value(),
                       .height_m = row.truth ? row.truth->height_m : row.height_m,
                       .speed_m_s = row.truth ? row.truth->speed_m_s : row.speed_m_s,
                       .rate_rad_s = row.truth ? row.truth->roll_rate_rad_s : row.roll_rate_rad_s,
                       .angle_rad = row.roll_angle_rad,
                       .offset_rad = row.truth ? row.truth->disturbance_rad : 0.0};
    reference_rad_ = row.reference_rad;
  }
  if (opening_ && !is_over_) {
    const double speed_m_s = row.truth ? row.truth->speed_m_s : row.speed_m_s;
    is_over_ = !controls || row.reference_rad != reference_rad_ || speed_m_s < slowest_held_m_s;
    if (!is_over_) {
      watch_capture(row, so_far);
    }
  }
}

void OpeningWatch::watch_capture(const flight::Row& row, const flight::Flight& so_far) {
  last_s_ = row.time_s;
  const auto settles_rad = flight::settle_point_rad(row, so_far);
  const bool is_within =
      settles_rad && std::abs(row.truth->roll_angle_rad - zero_.rad() - *settles_rad) <= captured_rad;
  if (!is_within) {
    within_since_s_.reset();
  } else if (!within_since_s_) {
    within_since_s_ = row.time_s;
  }
}

std::optional<Opening> OpeningWatch::found(const flight::Clock& clock) const {
  std::optional<Opening> all = opening_;
  if (all) {
    if (within_since_s_ && last_s_ - *within_since_s_ >= shortest_capture_s) {
      all->captured_after_s = *within_since_s_ - all->time_s;
    }
    all->time_s = clock(all->time_s);
  }
  return all;
}

}  // namespace fantail::dormancy
