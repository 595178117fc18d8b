// SPDX-License-Identifier: MIT
#include <array>
#include <bit>
#include <cstring>

#include "avionics/memory_sum.hpp"

namespace fantail::avionics {
namespace {

using Four [[gnu::vector_size(16)]] = std::uint32_t;
constexpr std::size_t word_size = 4;
// After so many words each has been turned all the way round, so that those of one place in every block can be added
// before they are turned.
constexpr std::size_t block_words = 32;
using Block = std::array<Four, block_words / 4>;

Four turned(Four words, int bits) { return words << bits | words >> (32 - bits); }

std::uint32_t sum_of(const Block& places) {
  // Halves onto each other: the first is that many words older.
  std::array<Four, 4> sixteen{};
  for (std::size_t i = 0; i < sixteen.size(); ++i) {
    sixteen[i] = turned(places[i], 16) ^ places[i + 4];
  }
  const Four early = turned(sixteen[0], 8) ^ sixteen[2];
  const Four late = turned(sixteen[1], 8) ^ sixteen[3];
  const Four four = turned(early, 4) ^ late;
  std::uint32_t sum = 0;
  for (int i = 0; i < 4; ++i) {
    sum = std::rotl(sum, 1) ^ four[i];
  }
  return sum;
}

}  // namespace

std::uint32_t memory_sum(std::span<const std::byte> memory) {
  Block places{};
  for (; memory.size() >= sizeof(Block); memory = memory.subspan(sizeof(Block))) {
    Block block;
    std::memcpy(&block, memory.data(), sizeof block);
    for (std::size_t i = 0; i < places.size(); ++i) {
      places[i] ^= block[i];
    }
  }
  std::uint32_t sum = sum_of(places);
  for (; memory.size() >= word_size; memory = memory.subspan(word_size)) {
    std::uint32_t word = 0;
    std::memcpy(&word, memory.data(), word_size);
    sum = std::rotl(sum, 1) ^ word;
  }
  return sum;
}

}  // namespace fantail::avionics
