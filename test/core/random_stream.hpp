// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::core {

/// Long random streams out of one seed that rapidcheck draws, prints and shrinks: a stream of thousands of samples
/// would take rapidcheck itself minutes. SplitMix64; the same numbers on every machine.
class RandomStream {
 public:
  explicit RandomStream(std::uint32_t seed) : state_{seed} {}

  /// In [0, 1).
  double unit() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
  }
  bool chance(double probability) { return unit() < probability; }
  float between(float low, float high) {
    return static_cast<float>(static_cast<double>(low) +
                              unit() * (static_cast<double>(high) - static_cast<double>(low)));
  }
  /// From low to high, both included.
  int whole(int low, int high) { return low + static_cast<int>(unit() * (high - low + 1)); }

 private:
  std::uint64_t state_;
};

}  // namespace fantail::core
