// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "flight/flight.hpp"
#include "sim/scenario.hpp"

namespace fantail::fly {

/// Those of speeds_under_control_m_s(), row by row.
class SpeedsUnderControl {
 public:
  void add(const flight::Row& row) {
    const double speed_m_s = row.truth->speed_m_s;
    if (row.phase == core::Phase::controlling &&
        (all_.empty() || !(speed_m_s < std::min(all_.front(), flight::slowest_held_m_s)))) {
      all_.push_back(speed_m_s);
    }
  }
  [[nodiscard]] std::vector<double> take() { return std::move(all_); }

 private:
  std::vector<double> all_;
};

/// The margins of the roll loop at the lowest, the median, the top and the worst of these speeds, by speed. Empty
/// without control and where the gain of the loop never reaches one.
[[nodiscard]] std::vector<flight::LoopMargin> loop_margins(const sim::Scenario& scenario,
                                                           std::vector<double> speeds_m_s);

}  // namespace fantail::fly
