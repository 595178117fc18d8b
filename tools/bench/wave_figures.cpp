// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "bench/turn_figures.hpp"

namespace fantail::bench {
namespace {

constexpr double turn_rad = 2.0 * std::numbers::pi;
constexpr std::size_t swing_in = 200;

struct Phasor {
  double sine;
  double cosine;
};

double determinant(const std::array<std::array<double, 3>, 3>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// Least squares of a sine, a cosine and a constant; by Cramer's rule, because it is three by three.
std::optional<Phasor> phasor(const std::vector<double>& values, const Window& window, double frequency_hz) {
  std::array<std::array<double, 3>, 3> normal{};
  std::array<double, 3> right{};
  for (std::size_t i = window.begin; i < window.end; ++i) {
    if (std::isnan(values[i])) {
      continue;
    }
    const double angle = turn_rad * frequency_hz * tick_s * static_cast<double>(i - window.begin);
    const std::array<double, 3> basis{std::sin(angle), std::cos(angle), 1.0};
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) {
        normal[row][column] += basis[row] * basis[column];
      }
      right[row] += basis[row] * values[i];
    }
  }
  const double whole = determinant(normal);
  const double n = normal[2][2];
  if (n < 50.0 || whole < 1e-3 * n * n * n) {  // n^3 / 4 for whole waves
    return std::nullopt;
  }
  std::array<double, 2> solution{};
  for (std::size_t unknown = 0; unknown < 2; ++unknown) {
    auto replaced = normal;
    for (std::size_t row = 0; row < 3; ++row) {
      replaced[row][unknown] = right[row];
    }
    solution[unknown] = determinant(replaced) / whole;
  }
  return Phasor{solution[0], solution[1]};
}

}  // namespace

void add_wave(const Course& course, double frequency_hz, Figures& f) {
  const auto first = std::ranges::find(course.part, Part::sine);
  const auto last = std::find_if(first, course.part.end(), [](Part part) { return part != Part::sine; });
  Window window{static_cast<std::size_t>(first - course.part.begin()),
                static_cast<std::size_t>(last - course.part.begin())};
  window.begin += std::min(window.size() / 3, swing_in);  // the servo takes some time constants to swing in
  const auto command = phasor(course.command_rad, window, frequency_hz);
  const auto encoder = phasor(course.encoder_rad, window, frequency_hz);
  if (!command || !encoder) {
    return;
  }
  const double told_rad = std::hypot(command->sine, command->cosine);
  const double moved_rad = std::hypot(encoder->sine, encoder->cosine);
  constexpr double least_rad = 1e-4;
  if (told_rad < least_rad) {
    return;
  }
  f.amplitude_ratio = moved_rad / told_rad;
  if (moved_rad > 0.05 * told_rad) {
    const double lag_rad = std::atan2(command->cosine, command->sine) - std::atan2(encoder->cosine, encoder->sine);
    f.phase_lag_rad = lag_rad - turn_rad * std::floor(lag_rad / turn_rad);
  }
}

}  // namespace fantail::bench
