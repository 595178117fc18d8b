// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace fantail::hal::stm32f4::test {

/// White noise behind a second-order low-pass (Butterworth), sampled at 1 kHz: the exact step of its two states, each
/// of unit variance in the long run.
class LowPassedNoise {
 public:
  LowPassedNoise(double cutoff_hz, std::uint32_t seed) : random_{seed} {
    const double angle = std::numbers::pi * std::numbers::sqrt2 * cutoff_hz * 1e-3;
    const double decay = std::exp(-angle);
    f_[0] = decay * (std::cos(angle) + std::sin(angle));
    f_[1] = decay * std::numbers::sqrt2 * std::sin(angle);
    f_[2] = -f_[1];
    f_[3] = decay * (std::cos(angle) - std::sin(angle));
    const double q0 = 1.0 - f_[0] * f_[0] - f_[1] * f_[1];
    const double q1 = -f_[0] * f_[2] - f_[1] * f_[3];
    const double q2 = 1.0 - f_[2] * f_[2] - f_[3] * f_[3];
    l_[0] = std::sqrt(q0);
    l_[1] = q1 / l_[0];
    l_[2] = std::sqrt(q2 - l_[1] * l_[1]);
  }

  struct State {
    double value;
    double slope;
  };
  State begin() { return {gauss_(random_), gauss_(random_)}; }
  State after(const State& s) {
    const double a = gauss_(random_), b = gauss_(random_);
    return {f_[0] * s.value + f_[1] * s.slope + l_[0] * a, f_[2] * s.value + f_[3] * s.slope + l_[1] * a + l_[2] * b};
  }
  std::mt19937& random() { return random_; }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> gauss_;
  double f_[4];
  double l_[3];
};

}  // namespace fantail::hal::stm32f4::test
