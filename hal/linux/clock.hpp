// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

#include "hal/clock.hpp"

namespace fantail::hal::on_linux {

/// The PC's monotonic clock; its power-up is when the object was made.
class Clock final : public hal::Clock {
 public:
  [[nodiscard]] Microseconds now() const override {
    return std::chrono::duration_cast<Microseconds>(std::chrono::steady_clock::now() - start_);
  }
  /// For programs that sleep until a time of this clock.
  [[nodiscard]] std::chrono::steady_clock::time_point start() const { return start_; }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace fantail::hal::on_linux
