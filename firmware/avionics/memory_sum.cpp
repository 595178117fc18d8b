// SPDX-License-Identifier: MIT
#include "avionics/memory_sum.hpp"

#include <bit>
#include <cstring>

namespace fantail::avionics {

// Called, not written in: it is large, to be fast.
[[gnu::noinline]] std::uint32_t memory_sum(std::span<const std::byte> memory) {
  std::uint32_t sum = 0;
  const std::byte* const end = memory.data() + memory.size() / 4 * 4;
#pragma GCC unroll 8
  for (const std::byte* at = memory.data(); at != end; at += 4) {
    std::uint32_t word = 0;
    std::memcpy(&word, at, 4);
    sum = std::rotl(sum, 1) ^ word;
  }
  return sum;
}

}  // namespace fantail::avionics
