// SPDX-License-Identifier: MIT
#include <array>
#include <bit>
#include <cstring>

#include "avionics/memory_sum.hpp"
#include "avionics/memory_sum_words.hpp"

namespace fantail::avionics {
namespace {

using Four [[gnu::vector_size(16)]] = std::uint32_t;

Four four_at(const std::byte* at) {
  Four words;
  std::memcpy(&words, at, sizeof words);
  return words;
}

Four turned(Four words, int bits) { return words << bits | words >> (32 - bits); }

}  // namespace

std::uint32_t memory_sum(std::span<const std::byte> memory) {
  // After 32 words each has been turned all the way round, so those of one place in every block are added before they
  // are turned.
  constexpr std::size_t fours = 8;
  std::array<Four, fours> block{};
  const std::byte* at = memory.data();
  const std::byte* const end = at + memory.size() / 4 * 4;
  for (; end - at >= static_cast<std::ptrdiff_t>(sizeof block); at += sizeof block) {
#pragma GCC unroll 8
    for (std::size_t i = 0; i < fours; ++i) {
      block[i] ^= four_at(at + i * sizeof(Four));
    }
  }
  Four lanes{};
#pragma GCC unroll 8
  for (std::size_t i = 0; i < fours; ++i) {
    lanes = turned(lanes, 4) ^ block[i];
  }
  for (; end - at >= static_cast<std::ptrdiff_t>(sizeof lanes); at += sizeof lanes) {
    lanes = turned(lanes, 4) ^ four_at(at);
  }
  std::uint32_t sum = 0;
#pragma GCC unroll 4
  for (int i = 0; i < 4; ++i) {
    sum = std::rotl(sum, 1) ^ lanes[i];
  }
  return add_words(sum, at, end);
}

}  // namespace fantail::avionics
