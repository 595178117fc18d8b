// SPDX-License-Identifier: MIT
#include "avionics/memory_sum.hpp"

#include "avionics/memory_sum_words.hpp"

namespace fantail::avionics {

std::uint32_t memory_sum(std::span<const std::byte> memory) {
  return add_words(0, memory.data(), memory.data() + memory.size() / 4 * 4);
}

}  // namespace fantail::avionics
