// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/measurement.hpp"

namespace fantail::bench {
namespace {

constexpr double least_square_rad2 = 1e-9;  // a mean square; of 0.01 deg it is 3e-8

// On the rocket's clock, a value a tick.
std::vector<double> asked_wave(const Exercise& exercise, const Stretch& sine, std::size_t canard) {
  const double limit_rad = exercise.bounds().limit_rad[canard];
  const auto ticks = static_cast<std::size_t>(std::lround((sine.end_s - sine.begin_s) / tick_s));
  std::vector<double> wave;
  wave.reserve(ticks);
  for (std::size_t i = 0; i < ticks; ++i) {
    const auto asked = exercise.asked(sine.begin_s + tick_s * static_cast<double>(i))[canard];
    wave.push_back(std::clamp(static_cast<double>(asked->radians()), -limit_rad, limit_rad));
  }
  return wave;
}

double squares(const CanardTrace& trace, const std::vector<double>& wave, std::size_t begin, double centre_rad) {
  double sum = 0.0;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    const bool within = i >= begin && i - begin < wave.size();
    const double difference_rad = trace.command_rad[i] - (within ? wave[i - begin] : centre_rad);
    sum += difference_rad * difference_rad;
  }
  return sum;
}

std::size_t longest_standstill(const CanardTrace& trace, const Window& window) {
  std::size_t longest = 0;
  for (std::size_t i = window.begin, since = i; i < window.end; ++i) {
    since = trace.command_rad[i] == trace.command_rad[since] ? since : i;
    longest = std::max(longest, i + 1 - since);
  }
  return longest;
}

}  // namespace

std::optional<SentWave> sent_wave(const CanardTrace& trace, const Exercise& exercise, std::size_t canard) {
  const auto mark = static_cast<std::size_t>(std::ranges::find(trace.part, Part::sine) - trace.part.begin());
  const auto sine = std::ranges::find(exercise.stretches(), Part::sine, &Stretch::part);
  if (mark == trace.size() || sine == exercise.stretches().end()) {
    return std::nullopt;
  }
  const double centre_rad = exercise.bounds().centre_rad[canard];
  const std::vector<double> wave = asked_wave(exercise, *sine, canard);
  double of_wave = 0.0;
  for (const double asked_rad : wave) {
    of_wave += (asked_rad - centre_rad) * (asked_rad - centre_rad);
  }
  if (of_wave < least_square_rad2 * static_cast<double>(wave.size())) {
    return std::nullopt;
  }
  std::size_t begin = mark;
  double left = squares(trace, wave, begin, centre_rad);
  for (std::size_t other = mark > mark_slack ? mark - mark_slack : 0; other <= mark + mark_slack; ++other) {
    if (const double here = squares(trace, wave, other, centre_rad); here < left) {
      left = here;
      begin = other;
    }
  }
  SentWave sent{.difference = std::sqrt(left / of_wave)};
  sent.asked_rad.assign(trace.size(), centre_rad);
  const Window window{std::min(begin, trace.size()), std::min(begin + wave.size(), trace.size())};
  std::copy_n(wave.begin(), window.size(), sent.asked_rad.begin() + static_cast<std::ptrdiff_t>(window.begin));
  sent.longest_standstill = longest_standstill(trace, window);
  return sent;
}

// A tenth of the power of the wave, as steps of a sixth of its period have it: the amplitude is then 0.95 of the one
// asked for, and how far a canard goes beyond one that is just quick enough changes by less than a quarter of reach_deg
// (a test). Added are the steps of a PC that keeps its pace: a request every 5 ms, at a look up to 2 ms later.
double most_difference(double frequency_hz) {
  constexpr double share_of_power = 0.1;
  constexpr double own_step_s = 0.007;
  const double own = 2.0 * std::numbers::pi * frequency_hz * own_step_s;
  return std::sqrt(share_of_power + own * own / 12.0);
}

}  // namespace fantail::bench
