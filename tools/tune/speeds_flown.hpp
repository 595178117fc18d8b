// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "stability/speed_range.hpp"

namespace fantail::tune {

/// The air speeds under control.
struct SpeedsFlown {
  stability::SpeedRange range{};
  double median_m_s = 0.0;
  std::vector<double> evenly_in_time_m_s{};  ///< some, an equal part of the time each
};

[[nodiscard]] SpeedsFlown speeds_flown(std::vector<double> speeds_m_s);

}  // namespace fantail::tune
