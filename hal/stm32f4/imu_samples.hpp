// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "hal/sample.hpp"

namespace fantail::hal::stm32f4 {

// What stands in the data registers of an ICM-42688-P with FIFO_HOLD_LAST_DATA_EN = 0 (DS-000347 section 12.8): -32768
// until the first sample, and then what was measured, where the two lowest counts have become -32766.

[[nodiscard]] inline Counts big_endian_counts(std::span<const std::byte, 6> bytes) {
  Counts counts{};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto high = std::to_integer<std::uint16_t>(bytes[2 * i]);
    const auto low = std::to_integer<std::uint16_t>(bytes[2 * i + 1]);
    counts[i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(high << 8U | low));
  }
  return counts;
}

[[nodiscard]] inline bool are_valid(const Counts& counts) {
  return std::ranges::none_of(counts,
                              [](std::int16_t count) { return count == std::numeric_limits<std::int16_t>::min(); });
}

/// The lower end of the range becomes what hal::Counts calls the lower end.
[[nodiscard]] inline Counts with_true_ends(Counts counts) {
  constexpr std::int16_t lowest = -32766;
  std::ranges::replace_if(
      counts, [](std::int16_t count) { return count <= lowest; }, std::numeric_limits<std::int16_t>::min());
  return counts;
}

}  // namespace fantail::hal::stm32f4
