// SPDX-License-Identifier: MIT
#include "sim/random.hpp"

#include <cmath>

#include "sim/elementary.hpp"

namespace fantail::sim {
namespace {

/// Right edge of the lowest box, and the area of every layer, for 256 of them: the topmost box then ends at height 1.
constexpr double last_edge = 3.6541528853610087716;
constexpr double layer_area = 0.0049286732339746553474;

constexpr double density(double x) { return exponential(-0.5 * x * x); }

// std::sqrt is no constant expression in C++20. Newton from above lands next to the root; where it stops is the same
// everywhere.
constexpr double square_root(double x) {
  double root = x > 1.0 ? x : 1.0;
  while (true) {
    const double next = 0.5 * (root + x / root);
    if (!(next < root)) {
      return root;
    }
    root = next;
  }
}

constexpr Ziggurat cut_into_layers() {
  std::array<double, Ziggurat::layers + 1> edge{};
  Ziggurat z;
  // The lowest layer includes the tail; drawn as if it were a box of the same area.
  edge[0] = layer_area / density(last_edge);
  edge[1] = last_edge;
  z.height[1] = density(last_edge);
  for (std::size_t i = 2; i < Ziggurat::layers; ++i) {
    z.height[i] = z.height[i - 1] + layer_area / edge[i - 1];
    edge[i] = square_root(-2.0 * natural_log(z.height[i]));
  }
  z.height[Ziggurat::layers] = 1.0;
  for (std::size_t i = 0; i < Ziggurat::layers; ++i) {
    z.layer[i] = {.edge_per_step = 0x1p-24 * edge[i], .inner_edge = edge[i + 1]};
  }
  return z;
}

/// Is a point of the given layer, at a share of its height, below the density? All heights are taken relative to the
/// foot of the layer, where the density over the foot is e^d with d < 0.74: its series decides nearly always.
bool below_the_density(std::size_t layer, double value, double share) {
  const double edge = ziggurat.layer[layer].edge_per_step * 0x1p24;
  const double foot = ziggurat.height[layer];
  const double d = 0.5 * (edge * edge - value * value);
  const double beyond_series = share * (ziggurat.height[layer + 1] - foot) / foot - d * (1.0 + 0.5 * d);
  // The rest of the series is at least 0, and at most its first term d^3 / 6 over 1 - d / 4.
  if (beyond_series < 0.0) {
    return true;
  }
  return beyond_series < 0.21 * d * d * d && beyond_series + d * (1.0 + 0.5 * d) < exponential(d) - 1.0;
}

/// splitmix64 (Steele, Lea and Flood, 2014).
std::uint64_t split_mix(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15U;
  std::uint64_t z = state;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

}  // namespace

constexpr Ziggurat ziggurat = cut_into_layers();

Random::Random(std::uint64_t seed, std::uint64_t stream) : state_{} {
  // The seed is mixed before the stream joins it: else stream 1 of seed 1 would be stream 0 of seed 2.
  std::uint64_t state = split_mix(seed) + stream;
  for (std::uint64_t& word : state_) {
    word = split_mix(state);
  }
}

void Random::settle(std::span<const std::uint64_t> words, std::span<double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::uint32_t drawn = i % 2 == 0 ? lower(words[i / 2]) : upper(words[i / 2]);
    if (!(std::abs(values[i]) < layer(drawn).inner_edge)) {
      values[i] = beside_the_layer(drawn, values[i]);
    }
  }
}

double Random::beside_the_layer(std::uint32_t drawn, double value) {
  const std::size_t i = drawn % Ziggurat::layers;
  if (i == 0) {
    return std::copysign(tail(), value);
  }
  return below_the_density(i, value, uniform()) ? value : gaussian();
}

// Marsaglia (1964): exponential draws, thinned to the normal tail. 1 - uniform() is never 0.
double Random::tail() {
  for (;;) {
    const double beyond = -natural_log(1.0 - uniform()) / last_edge;
    const double test = -natural_log(1.0 - uniform());
    if (2.0 * test > beyond * beyond) {
      return last_edge + beyond;
    }
  }
}

}  // namespace fantail::sim
