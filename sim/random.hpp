// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace fantail::sim {

/// The normal density e^(-x^2/2) cut into layers of equal area, one upon the other (Marsaglia and Tsang, 2000).
struct Ziggurat {
  static constexpr std::size_t layers = 256;
  struct Layer {
    double edge_per_step;  ///< where the layer ends, over 2^24
    double inner_edge;     ///< where the next one ends: nearer than that, a point is below the density for certain
  };
  std::array<Layer, layers> layer{};
  std::array<double, layers + 1> height{};  ///< from height[i] to height[i + 1]
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

  /// Normal with mean 0 and variance 1, in steps of less than 5e-7; the tail is exact, not cut.
  [[nodiscard]] double gaussian() { return gaussians<1>()[0]; }

  /// Several at once. One word of 64 bits makes two of them, and all words are drawn before any is looked at, so that
  /// the state stays in registers.
  template <std::size_t count>
    requires(count <= 32)
  [[nodiscard]] std::array<double, count> gaussians() {
    std::array<std::uint32_t, 2 * ((count + 1) / 2)> drawn{};
    for (std::size_t i = 0; i < drawn.size(); i += 2) {
      const std::uint64_t word = bits();
      drawn[i] = static_cast<std::uint32_t>(word);
      drawn[i + 1] = static_cast<std::uint32_t>(word >> 32U);
    }
    std::array<double, count> values{};
    std::uint32_t outside = 0;  // a bit each, so that one branch does for all
    for (std::size_t i = 0; i < count; ++i) {
      values[i] = in_layer(drawn[i]);
      outside |= (is_inside(drawn[i], values[i]) ? 0U : 1U) << i;
    }
    if (outside != 0) [[unlikely]] {
      settle(outside, drawn, values);
    }
    return values;
  }

 private:
  // The lowest 8 bits choose the layer and the upper 24, made a signed odd number, the place in it: the two are
  // independent, and no place is zero, so both signs are as likely.
  static std::size_t layer(std::uint32_t drawn) { return drawn % Ziggurat::layers; }
  static double in_layer(std::uint32_t drawn) {
    return static_cast<double>((static_cast<std::int32_t>(drawn) >> 7) | 1) *
           ziggurat.layer[layer(drawn)].edge_per_step;
  }
  static bool is_inside(std::uint32_t drawn, double value) {
    return std::abs(value) < ziggurat.layer[layer(drawn)].inner_edge;
  }

  void settle(std::uint32_t outside, std::span<const std::uint32_t> drawn, std::span<double> values);
  [[nodiscard]] double beside_the_layer(std::uint32_t drawn);
  [[nodiscard]] double tail();

  std::array<std::uint64_t, 4> state_;
};

}  // namespace fantail::sim
