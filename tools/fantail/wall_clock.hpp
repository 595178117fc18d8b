// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>
#include <thread>

#include "core/time.hpp"

namespace fantail::tool {

/// Holds a simulated flight back to real time; the flight's bytes are the same as without it.
class WallClock {
 public:
  /// Returns when as much time has passed since the first call as between the two simulated times. A PC that was a
  /// little late catches up; one that has slept does not make up for it.
  void wait_for(core::Microseconds simulated) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::seconds most_debt{1};
    const auto now = Clock::now();
    if (!zero_ || now > *zero_ + simulated + most_debt) {
      zero_ = now - simulated;
    }
    std::this_thread::sleep_until(*zero_ + simulated);
  }

 private:
  std::optional<std::chrono::steady_clock::time_point> zero_;
};

}  // namespace fantail::tool
