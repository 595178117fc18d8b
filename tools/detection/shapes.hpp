// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "sim/random.hpp"
#include "sim/units.hpp"

namespace fantail::detection {

inline constexpr double step_s = 1e-3;
inline constexpr double g = sim::gravity_m_s2;
inline constexpr double degree = sim::radians_per_degree;
inline constexpr double largest_tilt_rad = 15.0 * degree;  ///< of the launch guide, on the pad

/// Even between the two, or even in the logarithm (both above zero).
[[nodiscard]] double uniform(sim::Random& random, double low, double high);
[[nodiscard]] double log_uniform(sim::Random& random, double low, double high);

/// A whole number of steps, at least one.
[[nodiscard]] std::size_t steps(double time_s);

/// sin(2 pi f t + phase) and its cosine, a step at a time.
class Oscillator {
 public:
  Oscillator(double frequency_hz, double phase_rad);
  void advance() {
    const double next = sine_ * step_cosine_ + cosine_ * step_sine_;
    cosine_ = cosine_ * step_cosine_ - sine_ * step_sine_;
    sine_ = next;
  }
  [[nodiscard]] double sine() const { return sine_; }
  [[nodiscard]] double cosine() const { return cosine_; }

 private:
  double sine_;
  double cosine_;
  double step_sine_;
  double step_cosine_;
};

/// Adds peak * sin(pi t / width) for 0 <= t <= width, which begins at `start_s`. What lies beyond the end is left out.
void add_half_sine(std::span<float> values, double start_s, double width_s, double peak);

/// Adds noise of this standard deviation in a band of a fifth of its middle: sim::Vibration's resonance, of one axis.
/// `envelope`, where there is one, multiplies it step by step.
void add_band_noise(std::span<float> values, double standard_deviation, double frequency_hz, sim::Random& random,
                    std::span<const float> envelope = {});

}  // namespace fantail::detection
