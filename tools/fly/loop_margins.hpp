// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "flight/flight.hpp"
#include "sim/scenario.hpp"

namespace fantail::fly {

/// Those of speeds_under_control_m_s(), row by row.
class SpeedsUnderControl {
 public:
  void add(const flight::Row& row) {
    if (row.phase == core::Phase::controlling && (all_.empty() || !(row.truth->speed_m_s < all_.front()))) {
      all_.push_back(row.truth->speed_m_s);
    }
  }
  [[nodiscard]] std::vector<double> take() { return std::move(all_); }

 private:
  std::vector<double> all_;
};

/// The margins of the roll loop at the speed at which control begins, and at the median, the top and the worst speed
/// from there on, by speed. Empty without control and where the gain of the loop never reaches one.
[[nodiscard]] std::vector<flight::LoopMargin> loop_margins(const sim::Scenario& scenario,
                                                           std::vector<double> speeds_m_s);

}  // namespace fantail::fly
