// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

namespace fantail::protocol {

// Numbers as they lie in a block or a frame: lowest byte first. Written without loops, because of a loop GCC does not
// see that it is one load or one store of the Cortex-M4, and leaves six instructions for each byte.

/// Enough for so many bytes, and no more: 64 bits are two registers.
template <std::size_t bytes>
using WordOf = std::conditional_t<(bytes > 4), std::uint64_t, std::uint32_t>;

template <std::size_t bytes>
  requires(bytes > 0 && bytes <= sizeof(std::uint64_t))
constexpr void put(std::span<std::byte> out, std::size_t at, std::uint64_t value) {
  // To the Cortex-M4 GCC gives four stores of a byte where nothing says that an address is even.
  if (std::endian::native == std::endian::little && !std::is_constant_evaluated()) {
    const auto word = static_cast<WordOf<bytes>>(value);
    std::memcpy(out.data() + at, &word, bytes);
    return;
  }
  // uncovered: for the compiler, and for a processor of the other byte order
  [word = static_cast<WordOf<bytes>>(value), first = out.data() + at]<std::size_t... i>(std::index_sequence<i...>) {
    ((first[i] = static_cast<std::byte>(word >> (8U * i))), ...);
  }(std::make_index_sequence<bytes>{});
}

template <std::size_t bytes>
  requires(bytes > 0 && bytes <= sizeof(std::uint64_t))
[[nodiscard]] constexpr std::uint64_t get(std::span<const std::byte> in, std::size_t at) {
  return [first = in.data() + at]<std::size_t... i>(std::index_sequence<i...>) {
    return ((static_cast<WordOf<bytes>>(first[i]) << (8U * i)) | ...);
  }(std::make_index_sequence<bytes>{});
}

}  // namespace fantail::protocol
