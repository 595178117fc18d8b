// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fantail::hal::sim {

// What a power cut leaves behind. The first two seeds are the ends, nothing done yet (0) and everything done (1); every
// other one is something between.

/// Bits that are set with a probability. SplitMix64: the same bits on every machine.
class RandomBits {
 public:
  explicit RandomBits(std::uint64_t seed) : state_{seed} {}

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
  }

  /// Each bit set in `of_256` of 256 cases.
  std::byte byte(std::uint64_t of_256) {
    std::byte bits{};
    for (unsigned bit = 0; bit < 8; ++bit) {
      if (next() % 256 < of_256) {
        bits |= std::byte{1} << bit;
      }
    }
    return bits;
  }

 private:
  std::uint64_t state_;
};

/// Of the bits that were to become zero, some have.
inline void tear_program(std::span<std::byte> cells, std::span<const std::byte> bytes, std::uint64_t seed) {
  RandomBits random{seed};
  const std::uint64_t share = seed == 0 ? 0 : seed == 1 ? 256 : random.next() % 257;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    cells[i] &= bytes[i] | ~random.byte(share);
  }
}

/// A sector is programmed to zeros before it is erased, so that all its cells wear alike: a cut leaves fewer ones than
/// there were, or more, or the old content behind a part that is already erased.
inline void tear_erase(std::span<std::byte> sector, std::uint64_t seed) {
  RandomBits random{seed};
  const std::uint64_t stage = random.next() % 3;
  const std::uint64_t share = random.next() % 257;
  const std::size_t erased = random.next() % (sector.size() + 1);
  for (std::size_t i = 0; i < sector.size(); ++i) {
    if (seed == 0) {
      continue;
    }
    if (seed == 1 || (stage == 2 && i < erased)) {
      sector[i] = std::byte{0xFF};
    } else if (stage == 0) {
      sector[i] &= random.byte(share);
    } else if (stage == 1) {
      sector[i] = random.byte(share);
    }
  }
}

}  // namespace fantail::hal::sim
