// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "hal/stm32f4/registers/can.hpp"

namespace fantail::hal::stm32f4 {

/// How a bit of 1 Mbit/s is made of the clock of the controller. RM0090 section 32.7.7.
struct CanBitTiming {
  std::uint32_t prescaler = 0;       ///< clock periods in a time quantum
  std::uint32_t before_sample = 0;   ///< quanta up to the sample point, without the one in which the bit begins
  std::uint32_t after_sample = 0;    ///< quanta
  std::uint32_t resynchronises = 0;  ///< quanta by which a bit may be moved to follow another node's clock

  /// For BTR, which holds each of them less one.
  [[nodiscard]] constexpr std::uint32_t bits() const {
    using namespace registers;
    return (prescaler - 1) | (before_sample - 1) << can_btr_ts1_place | (after_sample - 1) << can_btr_ts2_place |
           (resynchronises - 1) << can_btr_sjw_place;
  }
};

/// Empty when no divider of this clock makes 1 Mbit/s within 0.1 %. The sample point lies as near to 80 % as the quanta
/// let it, always between 75 and 87.5 %: late enough for a few metres of cable, and with enough behind it to follow a
/// node whose clock is off. At 42 MHz that is 17 of 21 quanta, 81.0 %.
[[nodiscard]] constexpr std::optional<CanBitTiming> can_bit_timing(std::uint32_t clock_hz) {
  constexpr std::uint32_t bits_per_s = 1'000'000;
  // ISO 11898 wants 8 at least; with more than 22 the 16 before the sample end before 75 %.
  constexpr std::uint32_t fewest_quanta = 8;
  constexpr std::uint32_t most_quanta = 22;
  constexpr std::uint32_t most_before_sample = 16;
  constexpr std::uint32_t most_resynchronised = 4;
  // The most quanta that fit come first: they place the sample point best.
  for (std::uint32_t prescaler = 1; prescaler <= clock_hz / (fewest_quanta * bits_per_s) + 1; ++prescaler) {
    const std::uint32_t unit_hz = prescaler * bits_per_s;
    const std::uint32_t quanta = (clock_hz + unit_hz / 2) / unit_hz;
    const std::uint32_t exact_hz = quanta * unit_hz;
    const std::uint32_t off_hz = clock_hz > exact_hz ? clock_hz - exact_hz : exact_hz - clock_hz;
    if (quanta >= fewest_quanta && quanta <= most_quanta && off_hz <= clock_hz / 1000) {
      const std::uint32_t before = std::min((8 * quanta + 5) / 10 - 1, most_before_sample);
      const std::uint32_t after = quanta - 1 - before;
      // As far as it goes: the processor's own oscillator, when the crystal has failed, is off by up to 1 %.
      return CanBitTiming{.prescaler = prescaler,
                          .before_sample = before,
                          .after_sample = after,
                          .resynchronises = std::min(after, most_resynchronised)};
    }
  }
  return std::nullopt;
}

}  // namespace fantail::hal::stm32f4
