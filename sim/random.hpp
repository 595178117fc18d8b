// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
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
  [[nodiscard]] std::array<double, count> gaussians() {
    std::array<std::uint64_t, (count + 1) / 2> words{};
    for (std::uint64_t& word : words) {
      word = bits();
    }
    // Both of a word side by side, as every PC multiplies and compares them; one branch does for all.
    std::array<double, count> values{};
    auto inside = Two{} == Two{};
    for (std::size_t i = 0; i < count; i += 2) {
      const std::uint64_t word = words[i / 2];
      const Ziggurat::Layer& a = layer(lower(word));
      const Ziggurat::Layer& b = layer(upper(word));
      const Two value = places(word) * Two{a.edge_per_step, b.edge_per_step};
      const bool wants_both = i + 1 < count;
      inside &= magnitude(value) < Two{a.inner_edge, wants_both ? b.inner_edge : nowhere};
      values[i] = value[0];
      if (wants_both) {
        values[i + 1] = value[1];
      }
    }
    if ((inside[0] & inside[1]) == 0) [[unlikely]] {
      settle(words, values);
    }
    return values;
  }

 private:
  using Two [[gnu::vector_size(2 * sizeof(double))]] = double;
  using TwoWords [[gnu::vector_size(2 * sizeof(double))]] = std::int64_t;
  using TwoIntegers [[gnu::vector_size(2 * sizeof(std::int32_t))]] = std::int32_t;
  static constexpr double nowhere = std::numeric_limits<double>::infinity();
  static Two magnitude(Two value) {
    constexpr std::int64_t all_but_sign = std::numeric_limits<std::int64_t>::max();
    return std::bit_cast<Two>(std::bit_cast<TwoWords>(value) & all_but_sign);
  }

  // The lowest 8 bits choose the layer and the upper 24, made a signed odd number, the place in it: the two are
  // independent, and no place is zero, so both signs are as likely.
  static const Ziggurat::Layer& layer(std::uint32_t drawn) { return ziggurat.layer[drawn % Ziggurat::layers]; }
  static Two places(std::uint64_t word) {
    return __builtin_convertvector((std::bit_cast<TwoIntegers>(word) >> 7) | 1, Two);
  }
  static std::uint32_t lower(std::uint64_t word) { return static_cast<std::uint32_t>(word); }
  static std::uint32_t upper(std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32U); }

  void settle(std::span<const std::uint64_t> words, std::span<double> values);
  [[nodiscard]] double beside_the_layer(std::uint32_t drawn, double value);
  [[nodiscard]] double tail();

  std::array<std::uint64_t, 4> state_;
};

}  // namespace fantail::sim
