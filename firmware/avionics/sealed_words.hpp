// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "protocol/crc32c.hpp"

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
  const auto put = [&out](std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) {
      out[at + i] = static_cast<std::byte>(value >> (8U * i));
    }
  };
  for (std::size_t i = 0; i < words; ++i) {
    put(4 * i, values[i]);
  }
  put(4 * words, protocol::crc32c(std::span{out}.first(4 * words)));
  return out;
}

/// Empty when the words are not intact, and for erased flash, which has to be asked for: the CRC-32C of four bytes of
/// ones is ones, so that erased flash would be a word with its right checksum.
template <std::size_t words>
[[nodiscard]] std::optional<std::array<std::uint32_t, words>> unseal(
    std::span<const std::byte, sealed_size<words>> bytes) {
  std::array<std::uint32_t, words + 1> values{};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    values[i / 4] |= static_cast<std::uint32_t>(bytes[i]) << (8U * (i % 4));
  }
  if (erased(bytes) || values[words] != protocol::crc32c(bytes.first(4 * words))) {
    return std::nullopt;
  }
  std::array<std::uint32_t, words> out{};
  std::copy_n(values.begin(), words, out.begin());
  return out;
}

}  // namespace fantail::avionics
