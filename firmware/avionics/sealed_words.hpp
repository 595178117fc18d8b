// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"

namespace fantail::avionics {

// A few words as they lie in flash: little-endian, and behind them the CRC-32C of them all.

template <std::size_t words>
inline constexpr std::size_t sealed_size = 4 * (words + 1);

[[nodiscard]] inline bool erased(std::span<const std::byte> bytes) {
  return std::ranges::all_of(bytes, [](std::byte byte) { return byte == std::byte{0xFF}; });
}

template <std::size_t words>
[[nodiscard]] std::array<std::byte, sealed_size<words>> seal(const std::array<std::uint32_t, words>& values) {
  std::array<std::byte, sealed_size<words>> out{};
  for (std::size_t i = 0; i < words; ++i) {
    protocol::put<4>(out, 4 * i, values[i]);
  }
  protocol::put<4>(out, 4 * words, protocol::crc32c(std::span{out}.first(4 * words)));
  return out;
}

/// Empty when the words are not intact, and for erased flash, which has to be asked for: the CRC-32C of four bytes of
/// ones is ones, so that erased flash would be a word with its right checksum.
template <std::size_t words>
[[nodiscard]] std::optional<std::array<std::uint32_t, words>> unseal(
    std::span<const std::byte, sealed_size<words>> bytes) {
  if (erased(bytes) || protocol::get<4>(bytes, 4 * words) != protocol::crc32c(bytes.first(4 * words))) {
    return std::nullopt;
  }
  std::array<std::uint32_t, words> out{};
  for (std::size_t i = 0; i < words; ++i) {
    out[i] = static_cast<std::uint32_t>(protocol::get<4>(bytes, 4 * i));
  }
  return out;
}

}  // namespace fantail::avionics
