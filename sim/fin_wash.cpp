// SPDX-License-Identifier: MIT
#include "sim/fin_wash.hpp"

#include <cstddef>

namespace fantail::sim {

double FinWash::moved_on(double canard_rad, double path_m) {
  // A millimetre per second: the quotient below would be that of two roundings, and there is no torque to speak of.
  constexpr double still_m = 1e-6;
  if (!(path_m > still_m)) {
    return angle_rad_;
  }
  if (knots_.empty()) {
    knots_.push_back(now_);
  }
  now_ = {.path_m = now_.path_m + path_m, .sum_m_rad = now_.sum_m_rad + canard_rad * path_m};
  const std::size_t knots = knots_.size();
  if (knots > 1 && now_.path_m - knots_[knots - 2].path_m < least_between_m_) {
    knots_.back() = now_;
  } else {
    knots_.push_back(now_);
  }
  const double met_m_rad = sum_at(now_.path_m - distance_m_);
  angle_rad_ = share_ * (met_m_rad - met_m_rad_) / path_m;
  met_m_rad_ = met_m_rad;
  return angle_rad_;
}

double FinWash::sum_at(double path_m) {
  while (knots_.size() > 1 && knots_[1].path_m <= path_m) {
    knots_.pop_front();
  }
  const Knot& before = knots_.front();
  if (knots_.size() == 1 || path_m <= before.path_m) {
    return before.sum_m_rad;
  }
  const Knot& after = knots_[1];
  const double share = (path_m - before.path_m) / (after.path_m - before.path_m);
  return before.sum_m_rad + share * (after.sum_m_rad - before.sum_m_rad);
}

}  // namespace fantail::sim
