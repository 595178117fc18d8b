// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/sample.hpp"

namespace fantail::hal::stm32f4 {

/// Three axes that measure never stand still: their noise moves the last bit. Told from the counts of new samples
/// alone, whether an axis, or all three, say the same for longer than that noise lets them.
///
/// How long that is follows from the data sheet's noise density and the low-pass behind it. A run of equal samples
/// grows by one with a probability that is largest when the true value lies in the middle of a count: for noise of 0.78
/// counts behind a second-order low-pass at 258 Hz, sampled at 1 kHz, 0.52; for half of that noise 0.83; for a quarter
/// 0.99 (test/hal/stm32f4/frozen_counts_test.cpp). The limits of a sensor hold the false alarms of its axes below 1e-9
/// in an hour.
class FrozenCounts {
 public:
  struct Limits {
    std::uint16_t one_axis;    ///< equal samples in a row, the first not counted
    std::uint16_t three_axes;  ///< the same, of all three at once
  };

  explicit constexpr FrozenCounts(const Limits& limits) : limits_{limits} {}

  /// Of each new sample. True when an axis is found frozen, and again each time it is.
  bool update(const Counts& counts);
  /// Somebody else has found all three frozen.
  void condemn();

  /// The last sample said the same as the one before, on all three axes.
  [[nodiscard]] bool repeated() const { return repeated_; }
  /// Not to be used. What was frozen once is believed again after each such axis has moved ten times.
  [[nodiscard]] bool frozen() const {
    return std::ranges::any_of(axes_, [](const Axis& axis) { return axis.doubts > 0; });
  }

 private:
  struct Axis {
    std::uint16_t run = 0;
    std::uint8_t doubts = 0;  ///< moves until it is believed again
  };

  Limits limits_;
  Counts last_{};
  std::array<Axis, 3> axes_{};
  std::uint16_t run_ = 0;
  bool repeated_ = false;
};

}  // namespace fantail::hal::stm32f4
