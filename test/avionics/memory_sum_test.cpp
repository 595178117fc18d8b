// SPDX-License-Identifier: MIT
#include "avionics/memory_sum.hpp"

#include <bit>

#include "test.hpp"

namespace fantail::avionics {
namespace {

// The same on every processor, whatever its way: at the ends of what each takes at once, too.
TEST(MemorySum, IsThatOfItsWordsOneByOne) {
  std::array<std::uint32_t, 300> words{};
  std::uint32_t drawn = 1;
  for (std::uint32_t& word : words) {
    drawn = drawn * 1664525U + 1013904223U;
    word = drawn;
  }
  std::uint32_t one_by_one = 0;
  for (std::size_t count = 0; count < words.size(); ++count) {
    ASSERT_EQ(memory_sum(std::as_bytes(std::span{words}.first(count))), one_by_one) << count;
    one_by_one = std::rotl(one_by_one, 1) ^ words[count];
  }
}

}  // namespace
}  // namespace fantail::avionics
