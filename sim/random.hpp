// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace fantail::sim {

/// The normal density e^(-x^2/2) cut into layers of equal area (Marsaglia and Tsang, 2000): layer i reaches from the
/// axis to edge[i] and from height[i] to height[i + 1].
struct Ziggurat {
  static constexpr std::size_t layers = 256;
  std::array<double, layers + 1> edge{};
  std::array<double, layers + 1> height{};
};
extern const Ziggurat ziggurat;

/// A stream of random numbers: xoshiro256++ (Blackman and Vigna, 2019). The same seed and stream give the same bytes
/// with every compiler and on every machine, which the distributions of the standard library do not promise.
class Random {
 public:
  /// Streams of one seed are independent of each other, and of the streams of any other seed.
  Random(std::uint64_t seed, std::uint64_t stream);

  /// Continues from a state of the generator, which must not be all zeros.
  explicit constexpr Random(const std::array<std::uint64_t, 4>& state) : state_{state} {}

  [[nodiscard]] std::uint64_t bits() {
    auto& s = state_;
    const std::uint64_t result = std::rotl(s[0] + s[3], 23) + s[0];
    const std::uint64_t shifted = s[1] << 17U;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= shifted;
    s[3] = std::rotl(s[3], 45);
    return result;
  }

  /// Even over [0, 1), in steps of 2^-53.
  [[nodiscard]] double uniform() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

  /// Normal with mean 0 and variance 1; the tail is exact, not cut.
  [[nodiscard]] double gaussian() {
    const std::uint64_t drawn = bits();
    const std::size_t layer = drawn % Ziggurat::layers;
    // The upper 54 bits as a signed number; the layer used the lowest 8, so the two are independent.
    const double share = static_cast<double>(static_cast<std::int64_t>(drawn) >> 10) * 0x1p-53;
    const double value = share * ziggurat.edge[layer];
    if ((value < 0.0 ? -value : value) < ziggurat.edge[layer + 1]) [[likely]] {
      return value;
    }
    return beside_the_layer(layer, value);
  }

 private:
  [[nodiscard]] double beside_the_layer(std::size_t layer, double value);
  [[nodiscard]] double tail();

  std::array<std::uint64_t, 4> state_;
};

}  // namespace fantail::sim
