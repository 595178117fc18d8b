// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace fantail::test {

/// Normally distributed numbers, the same on every machine: Box-Muller on a generator that the standard fixes.
class Gaussian {
 public:
  explicit Gaussian(std::uint64_t seed) : random_{seed} {}
  double operator()() {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  double uniform() { return (static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53; }
  std::mt19937_64 random_;
};

}  // namespace fantail::test
