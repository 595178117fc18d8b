// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

namespace fantail::sim {

/// Apogee, as an event of a whole flight: the first instant at which the rocket sinks from the highest point that it
/// reaches. A motor that pauses lets it sink and climb on: then the event is at the later, higher point.
class HighestPoint {
 public:
  /// Each step, in order. `apogee_s` is empty while the rocket is where it has never been before.
  void look(double time_s, double height_m, double up_m_s, std::optional<double>& apogee_s) {
    if (up_m_s < 0.0) {
      apogee_s = apogee_s.value_or(time_s);
    } else if (height_m > highest_m_) {
      apogee_s.reset();
    }
    highest_m_ = std::max(highest_m_, height_m);
  }

 private:
  double highest_m_ = 0.0;
};

}  // namespace fantail::sim
