// SPDX-License-Identifier: MIT
#include "avionics/memory_sum.hpp"

#include <cstring>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace fantail::avionics {
namespace {

std::uint32_t word_by_word(const std::vector<std::byte>& memory) {
  std::uint32_t sum = 0;
  for (std::size_t at = 0; at + 4 <= memory.size(); at += 4) {
    std::uint32_t word = 0;
    std::memcpy(&word, &memory[at], 4);
    sum = (sum << 1U | sum >> 31U) ^ word;
  }
  return sum;
}

RC_GTEST_PROP(MemorySum, IsThatOfTheWordsOneByOne, ()) {
  const auto length = *rc::gen::inRange<std::size_t>(0, 1500);
  const auto bytes = *rc::gen::container<std::vector<std::uint8_t>>(length, rc::gen::arbitrary<std::uint8_t>());
  std::vector<std::byte> memory(bytes.size());
  std::memcpy(memory.data(), bytes.data(), bytes.size());
  RC_ASSERT(memory_sum(memory) == word_by_word(memory));
}

TEST(MemorySum, ChangesWithEverySingleBit) {
  std::vector<std::byte> memory(1100, std::byte{0x5A});
  const std::uint32_t before = memory_sum(memory);
  for (std::size_t bit = 0; bit < 8 * memory.size(); ++bit) {
    const std::byte whole = memory[bit / 8];
    memory[bit / 8] ^= std::byte{1} << (bit % 8);
    ASSERT_NE(memory_sum(memory), before) << bit;
    memory[bit / 8] = whole;
  }
}

}  // namespace
}  // namespace fantail::avionics
