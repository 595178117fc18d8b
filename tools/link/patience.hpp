// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "hal/clock.hpp"

namespace fantail::link {

/// How long something is waited for. To be asked at every look, and what lies between two looks counts for 0.25 s at
/// the most: while a busy PC held this process up nobody listened, and an avionics on the same PC could not speak.
class Patience {
 public:
  Patience(hal::Microseconds longest, hal::Microseconds now) : longest_{longest}, last_look_{now} {}

  [[nodiscard]] bool ends(hal::Microseconds now) {
    waited_ += std::clamp(now - last_look_, hal::Microseconds{0}, longest_stride);
    last_look_ = now;
    return waited_ >= longest_;
  }
  /// What was waited for has come, and the next of its kind is waited for as long.
  void begin_again() { waited_ = {}; }

 private:
  static constexpr hal::Microseconds longest_stride{250'000};

  hal::Microseconds longest_;
  hal::Microseconds last_look_;
  hal::Microseconds waited_{};
};

}  // namespace fantail::link
