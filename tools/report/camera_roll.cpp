// SPDX-License-Identifier: MIT
#include <cmath>

#include "report/figures.hpp"

namespace fantail::report {

void CameraRollWatch::add(const flight::Row& row) {
  if (!core::is_flight(row.phase) || !row.truth || !row.truth->geometric_roll_rad) {
    return;
  }
  const double apart_rad = *row.truth->geometric_roll_rad - row.truth->roll_angle_rad;
  if (!found_) {
    zero_rad_ = apart_rad;
    found_.emplace();
  }
  found_->at_end_rad = apart_rad - zero_rad_;
  if (std::abs(found_->at_end_rad) > std::abs(found_->largest_rad)) {
    found_->largest_rad = found_->at_end_rad;
  }
}

}  // namespace fantail::report
