// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace fantail::avionics {

// Who has which bytes of the memory that a reset leaves alone (the STM32F405's 4 kB of backup SRAM): two halves for a
// flight that may have to be resumed, which are written in turn, and behind them the record of a crash.

inline constexpr std::size_t backup_size = 4096;
inline constexpr std::size_t crash_room = 256;
inline constexpr std::size_t flight_half_size = (backup_size - crash_room) / 2;
inline constexpr std::size_t crash_begin = 2 * flight_half_size;

/// Half 0 or 1; empty when there is no such memory.
[[nodiscard]] inline std::span<std::byte> flight_half(std::span<std::byte> memory, std::size_t half) {
  return memory.size() < backup_size ? std::span<std::byte>{}
                                     : memory.subspan(half * flight_half_size, flight_half_size);
}

/// Empty when there is no such memory.
[[nodiscard]] inline std::span<std::byte> crash_place(std::span<std::byte> memory) {
  return memory.size() < backup_size ? std::span<std::byte>{} : memory.subspan(crash_begin, crash_room);
}

}  // namespace fantail::avionics
