// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstdint>

namespace fantail::core {

/// Time since the clock of the board (or the world) started. Instants are subtracted as integers; only a difference
/// becomes a float, because a float of a time of day has lost the microseconds.
using Microseconds = std::chrono::duration<std::int64_t, std::micro>;

/// From one step of the flight law to the next, when none is late.
inline constexpr Microseconds tick_period{1'000};

/// static_cast<float>(value), to the last bit. Of the Cortex-M4's library that would take half a kilobyte of arithmetic
/// in software, so it is shifted until its FPU can convert it; what falls off stays in the last bit, for the rounding.
[[nodiscard, gnu::noinline, gnu::cold]] constexpr float wide_to_float(std::int64_t value) {
  constexpr int most_bits = 31;
  constexpr int bias = 127;
  constexpr int fraction_bits = 23;
  const auto magnitude = value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
  const int shift = std::max(0, 64 - most_bits - std::countl_zero(magnitude));
  const std::uint64_t kept = magnitude >> static_cast<unsigned>(shift);
  const bool exact = kept << static_cast<unsigned>(shift) == magnitude;
  const float number = static_cast<float>(static_cast<std::int32_t>(kept | (exact ? 0U : 1U))) *
                       std::bit_cast<float>(static_cast<std::uint32_t>(bias + shift) << fraction_bits);
  return value < 0 ? -number : number;
}

/// A difference of two instants as seconds; good to 1 us below 16 s.
[[nodiscard]] constexpr float seconds(Microseconds difference) {
  // Up to half an hour fits 32 bits, which the FPU of the Cortex-M4 converts in one instruction; 64 bits are a call.
  const auto narrow = static_cast<std::int32_t>(difference.count());
  return (narrow == difference.count() ? static_cast<float>(narrow) : wide_to_float(difference.count())) * 1e-6F;
}

/// A span of time that can be neither negative nor longer than `most`. By value: std::clamp picks one of three
/// references, which sends 64-bit numbers through memory.
[[nodiscard]] constexpr Microseconds up_to(Microseconds most, Microseconds span) {
  if (span > most) {
    return most;
  }
  return span < Microseconds{0} ? Microseconds{0} : span;
}

/// A value in whole millionths, off by at most 0.55 of one; valid within +-3600. Whole units are split off first,
/// because the product of the two would already have lost the last digits.
[[nodiscard]] constexpr std::int64_t millionths(float value) {
  // Both parts fit 32 bits, which the Cortex-M4 converts itself; to 64 bits its library goes by way of doubles.
  const auto whole = static_cast<std::int32_t>(value);
  const float rest = (value - static_cast<float>(whole)) * 1e6F;
  return std::int64_t{whole} * 1'000'000 + static_cast<std::int32_t>(rest < 0.0F ? rest - 0.5F : rest + 0.5F);
}

/// Mind that above 8 s a float no longer names every microsecond: whoever reads times from text converts them without
/// one. Valid for 0 <= value_s <= 3600 s.
[[nodiscard]] constexpr Microseconds from_seconds(float value_s) { return Microseconds{millionths(value_s)}; }

}  // namespace fantail::core
