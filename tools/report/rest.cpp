// SPDX-License-Identifier: MIT
#include <cmath>

#include "report/hold.hpp"

namespace fantail::report {
namespace {

std::optional<double> farther(const std::optional<double>& one, const std::optional<double>& other) {
  return !one || (other && std::abs(*other) > std::abs(*one)) ? other : one;
}

}  // namespace

void RunningRest::add(const flight::Row& row, double roll_rad, const flight::Flight& flight) {
  const double error_rad = roll_rad - row.reference_rad;
  if (!std::isfinite(error_rad)) {
    return;
  }
  sum_of_errors_rad_ += std::abs(error_rad);
  rows_ += 1;
  if (begins_ || row.reference_rad != reference_rad_) {
    farthest_rad_ = farthest_with(stretch_);
    stretch_ = {};
    reference_rad_ = row.reference_rad;
    settles_at_s_ = row.time_s + (begins_ ? first_settling_time_s(flight) : step_settling_time_s(flight));
    begins_ = false;
  }
  if (row.time_s < settles_at_s_ - row_time_rounding_s) {
    return;
  }
  stretch_.begin_s = stretch_.rows == 0 ? row.time_s : stretch_.begin_s;
  stretch_.end_s = row.time_s;
  stretch_.sum_rad += error_rad;
  stretch_.rows += 1;
  if (const std::optional<double> settles_rad = flight::settle_point_rad(row, flight)) {
    of_law_rad_ = farther(of_law_rad_, *settles_rad - row.reference_rad);
  }
}

std::optional<double> RunningRest::farthest_with(const Stretch& stretch) const {
  if (stretch.rows == 0 || (farthest_rad_ && stretch.end_s - stretch.begin_s < shortest_rest_s)) {
    return farthest_rad_;
  }
  return farther(farthest_rad_, stretch.sum_rad / static_cast<double>(stretch.rows));
}

std::optional<double> RunningRest::rest_error_rad() const {
  const std::optional<double> farthest_rad = farther(farthest_with(stretch_), of_law_rad_);
  return farthest_rad ? std::optional{std::abs(*farthest_rad)} : std::nullopt;
}

std::optional<double> RunningRest::mean_error_rad() const {
  return rows_ > 0 ? std::optional{sum_of_errors_rad_ / static_cast<double>(rows_)} : std::nullopt;
}

}  // namespace fantail::report
