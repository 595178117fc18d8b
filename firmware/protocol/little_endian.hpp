// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fantail::protocol {

// Numbers as they lie in a block or a frame: lowest byte first.

template <std::size_t bytes>
constexpr void put(std::span<std::byte> out, std::size_t at, std::uint64_t value) {
  for (std::size_t i = 0; i < bytes; ++i) {
    out[at + i] = static_cast<std::byte>(value >> (8U * i));
  }
}

template <std::size_t bytes>
[[nodiscard]] constexpr std::uint64_t get(std::span<const std::byte> in, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    value |= static_cast<std::uint64_t>(in[at + i]) << (8U * i);
  }
  return value;
}

}  // namespace fantail::protocol
