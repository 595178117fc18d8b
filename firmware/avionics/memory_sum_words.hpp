// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace fantail::avionics {

/// memory_sum(), word by word, from a sum of the words before these: what is left where several are taken at once.
[[nodiscard]] inline std::uint32_t add_words(std::uint32_t sum, const std::byte* at, const std::byte* end) {
  for (; at != end; at += 4) {
    std::uint32_t word = 0;
    std::memcpy(&word, at, 4);
    sum = std::rotl(sum, 1) ^ word;
  }
  return sum;
}

}  // namespace fantail::avionics
