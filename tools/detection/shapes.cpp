// SPDX-License-Identifier: MIT
#include "detection/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/elementary.hpp"
#include "sim/rotation.hpp"

namespace fantail::detection {

double uniform(sim::Random& random, double low, double high) { return low + (high - low) * random.uniform(); }

double log_uniform(sim::Random& random, double low, double high) {
  return low * sim::exponential(random.uniform() * sim::natural_log(high / low));
}

std::size_t steps(double time_s) { return static_cast<std::size_t>(std::max(1.0, time_s / step_s + 0.5)); }

Oscillator::Oscillator(double frequency_hz, double phase_rad) {
  const auto start = sim::sine_cosine(phase_rad);
  const auto step = sim::sine_cosine(2.0 * std::numbers::pi * frequency_hz * step_s);
  sine_ = start.sine;
  cosine_ = start.cosine;
  step_sine_ = step.sine;
  step_cosine_ = step.cosine;
}

void add_half_sine(std::span<float> values, double start_s, double width_s, double peak) {
  const auto first = static_cast<std::size_t>(std::ceil(std::max(0.0, start_s) / step_s - 1e-9));
  const double into_s = static_cast<double>(first) * step_s - start_s;
  Oscillator wave{0.5 / width_s, std::numbers::pi * into_s / width_s};
  double t = into_s;
  for (std::size_t i = first; i < values.size() && t <= width_s + 1e-9; ++i) {
    values[i] += static_cast<float>(peak * wave.sine());
    wave.advance();
    t += step_s;
  }
}

void add_band_noise(std::span<float> values, double standard_deviation, double frequency_hz, sim::Random& random,
                    std::span<const float> envelope) {
  const double radius = sim::exponential(-std::numbers::pi * 0.2 * frequency_hz * step_s);
  const double keep_last = 2.0 * radius * sim::sine_cosine(2.0 * std::numbers::pi * frequency_hz * step_s).cosine;
  const double keep_one_before = -radius * radius;
  // x[n] - x[n-2] of such a resonance has the variance 2 drive^2 / (1 - radius^2).
  const double drive = standard_deviation * std::sqrt(0.5 * (1.0 - radius * radius));
  double last = 0.0;
  double one_before = 0.0;
  for (std::size_t i = 0; i < values.size(); i += 2) {
    for (std::size_t j = i; const double drawn : random.gaussians<2>()) {
      const double next = keep_last * last + keep_one_before * one_before + drive * drawn;
      if (j < values.size()) {
        values[j] +=
            static_cast<float>((next - one_before) * (envelope.empty() ? 1.0 : static_cast<double>(envelope[j])));
      }
      one_before = last;
      last = next;
      ++j;
    }
  }
}

}  // namespace fantail::detection
