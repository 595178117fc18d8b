// SPDX-License-Identifier: MIT
#include <algorithm>

#include "report/sections.hpp"

namespace fantail::report {

std::optional<Landing> landing_of(const flight::Flight& flight) {
  const auto& apogee_s = flight.events.apogee_s;
  if (!apogee_s || flight.path_frame != flight::PathFrame::compass) {
    return std::nullopt;
  }
  const auto is_down = [&](const flight::PathPoint& point) {
    return point.time_s > *apogee_s && point.height_m <= 0.0;
  };
  const auto found = std::ranges::find_if(flight.path, is_down);
  if (found == flight.path.end()) {
    return std::nullopt;
  }
  const auto& parachute_s = flight.events.parachute_s;
  return Landing{.at = *found, .under_parachute = parachute_s && *parachute_s < found->time_s};
}

}  // namespace fantail::report
