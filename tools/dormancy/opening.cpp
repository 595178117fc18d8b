// SPDX-License-Identifier: MIT
#include "dormancy/opening.hpp"

#include <utility>

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
  }
  if (opening_ && !controls) {
    capture_.end();
    pauses_ = true;
  } else if (opening_) {
    if (std::exchange(pauses_, false)) {
      opening_->reopenings += 1;
      capture_ = report::CaptureWatch{tunnel_};
    }
    const auto settles_rad = report::holds_an_angle(so_far) ? flight::settle_point_rad(row, so_far) : std::nullopt;
    capture_.add(row,
                 settles_rad ? std::optional{row.truth->roll_angle_rad - zero_.rad() - *settles_rad} : std::nullopt);
  }
}

std::optional<Opening> OpeningWatch::found(const flight::Clock& clock) const {
  std::optional<Opening> all = opening_;
  if (all) {
    all->captured_after_s = capture_.found(clock).after_s;
    all->time_s = clock(all->time_s);
  }
  return all;
}

}  // namespace fantail::dormancy
