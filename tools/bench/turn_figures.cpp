// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "bench/measurement.hpp"
#include "bench/readings.hpp"

namespace fantail::bench {
namespace {

bool reported_in(const CanardTrace& trace, const Window& window) {
  for (std::size_t i = window.begin; i < window.end; ++i) {
    if (trace.limited[i]) {
      return true;
    }
  }
  return false;
}

// Way from the centre over the way commanded.
std::optional<double> share(const std::optional<double>& reached_rad, const std::optional<double>& told_rad,
                            double centre_rad, double told_centre_rad) {
  constexpr double least_way_rad = 1e-3;
  if (!reached_rad || !told_rad || std::abs(*told_rad - told_centre_rad) < least_way_rad) {
    return std::nullopt;
  }
  return (*reached_rad - centre_rad) / (*told_rad - told_centre_rad);
}

constexpr std::size_t time_to_settle = 180;
constexpr std::size_t before_step = 60;
constexpr double least_share = 0.15;  // of the step commanded; less is not a step

// The rest of a hold, once the canard stands; all of it when it is too short for that.
Window settled(const Window& hold) {
  return hold.size() > time_to_settle + before_step ? Window{hold.begin + time_to_settle, hold.end} : hold;
}

double overshoot_rad(const CanardTrace& trace, const Window& hold, double from_rad, double to_rad) {
  constexpr std::size_t length = 5;
  double farthest = 0.0;
  for (std::size_t begin = hold.begin; begin + length <= hold.end; ++begin) {
    double sum = 0.0;
    for (std::size_t i = begin; i < begin + length; ++i) {
      sum += trace.encoder_rad[i];
    }
    const double beyond = (sum / static_cast<double>(length) - to_rad) * (to_rad > from_rad ? 1.0 : -1.0);
    farthest = beyond > farthest ? beyond : farthest;  // false for what was not read
  }
  return farthest;
}

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

Window sine_window(const CanardTrace& trace) {
  const auto first = std::ranges::find(trace.part, Part::sine);
  const auto last = std::find_if(first, trace.part.end(), [](Part part) { return part != Part::sine; });
  return {static_cast<std::size_t>(first - trace.part.begin()), static_cast<std::size_t>(last - trace.part.begin())};
}

// The servo takes some time constants to swing in.
Window swung_in(const Window& sine) { return {sine.begin + std::min(sine.size() / 3, swing_in), sine.end}; }

}  // namespace

void add_ends(const CanardTrace& trace, Figures& f) {
  const Window above = at_rest(trace, Part::hold_positive);
  const Window below = at_rest(trace, Part::hold_negative);
  f.reached_positive_rad = level_rad(trace, above);
  f.reached_negative_rad = level_rad(trace, below);
  f.saturated = beyond_bus(f.reached_positive_rad.value_or(0.0)) || beyond_bus(f.reached_negative_rad.value_or(0.0));
  if (above.size() == 0 || below.size() == 0) {
    return;
  }
  f.limit_reported = reported_in(trace, above) && reported_in(trace, below);
  f.told_positive_rad = trace.command_rad[above.end - 1];
  f.told_negative_rad = trace.command_rad[below.end - 1];
  const double told_rad = *f.told_positive_rad - *f.told_negative_rad;
  if (f.reached_positive_rad && f.reached_negative_rad && told_rad > 0.0) {
    f.gain = (*f.reached_positive_rad - *f.reached_negative_rad) / told_rad;
  }
}

void add_centre(const CanardTrace& trace, Figures& f) {
  const Window above = at_rest(trace, Part::centre_from_above);
  const Window below = at_rest(trace, Part::centre_from_below);
  const auto from_above = level_rad(trace, above);
  const auto from_below = level_rad(trace, below);
  if (!from_above || !from_below) {
    return;
  }
  const double told_rad = trace.command_rad[above.end - 1];
  f.from_above_rad = *from_above - told_rad;
  f.from_below_rad = *from_below - trace.command_rad[below.end - 1];
  f.centring_error_rad = 0.5 * (*f.from_above_rad + *f.from_below_rad);
  f.backlash_rad = std::abs(*f.from_above_rad - *f.from_below_rad);
  const double centre_rad = told_rad + *f.centring_error_rad;
  f.positive_share = share(f.reached_positive_rad, f.told_positive_rad, centre_rad, told_rad);
  f.negative_share = share(f.reached_negative_rad, f.told_negative_rad, centre_rad, told_rad);
}

void add_rest(const CanardTrace& trace, Figures& f) {
  constexpr double by_chance = 5.0;  // standard errors: a PC that stalled may have left 20 readings of a rest
  double squares = 0.0;
  double readings = 0.0;
  double levels = 0.0;
  double counted = 0.0;
  for (const Part part : {Part::settle, Part::hold_positive, Part::centre_from_above, Part::hold_negative,
                          Part::centre_from_below, Part::step_out, Part::step_home}) {
    const Window window = at_rest(trace, part);
    if (const auto rest = rest_of(trace, window)) {
      squares += rest->variance_rad2 * (rest->readings - 2.0);
      readings += rest->readings - 2.0;
      f.drift_rad_s =
          std::max(f.drift_rad_s.value_or(0.0), std::abs(rest->drift_rad_s) - by_chance * rest->drift_error_rad_s);
    }
    if (const auto level = level_rad(trace, window)) {
      levels += *level;
      counted += 1.0;
    }
  }
  if (readings > 0.0) {
    f.noise_rad = std::sqrt(squares / readings);
  }
  if (counted > 0.0) {
    f.stands_at_rad = levels / counted;
  }
}

void add_steps(const CanardTrace& trace, Part widest, Figures& f) {
  if (const std::size_t begin = step_begin(trace, Part::step_out); begin < trace.size()) {
    const Window hold = while_command_stands(trace, begin);
    const auto from = level_rad(trace, {begin > before_step ? begin - before_step : 0, begin});
    const auto to = level_rad(trace, settled(hold));
    const double told_rad = trace.command_rad[begin] - trace.command_rad[begin - 1];
    if (from && to && std::abs(*to - *from) > least_share * std::abs(told_rad)) {
      f.step_time_s = rise_time_s(trace, hold, *from, *to);
      f.overshoot_rad = overshoot_rad(trace, hold, *from, *to);
    }
    if (widest == Part::step_out) {
      f.told_positive_rad = trace.command_rad[begin];
      f.reached_positive_rad = to;
      f.saturated = beyond_bus(to.value_or(0.0));
      const auto home = level_rad(trace, at_rest(trace, Part::step_home));
      if (from && to && home) {
        f.gain = (*to - *from) / told_rad;
        f.from_above_rad = *from - trace.command_rad[begin - 1];
        f.from_below_rad = *home - trace.command_rad[begin - 1];
        f.centring_error_rad = 0.5 * (*f.from_above_rad + *f.from_below_rad);
      }
    }
  }
  const std::size_t across = step_begin(trace, widest);
  if (across < trace.size() && f.sign.value_or(0) != 0) {
    f.slew_rad_s = fastest_rad_s(trace, while_command_stands(trace, across));
    f.slew_way_rad = std::abs(trace.command_rad[across] - trace.command_rad[across - 1]);
  }
}

void add_wave(const CanardTrace& trace, double frequency_hz, Figures& f) {
  const Window sine = sine_window(trace);
  const auto before = level_rad(trace, at_rest(trace, Part::settle));
  const auto after = level_rad(trace, {std::min(sine.end + time_to_settle, trace.size()), trace.size()});
  if (before && after) {
    f.centring_error_rad = 0.5 * (*before + *after) - trace.command_rad.back();
  }
  const Window window = swung_in(sine);
  const auto command = phasor(trace.command_rad, window, frequency_hz);
  const auto encoder = phasor(trace.encoder_rad, window, frequency_hz);
  if (!command || !encoder) {
    return;
  }
  const double told_rad = std::hypot(command->sine, command->cosine);
  const double moved_rad = std::hypot(encoder->sine, encoder->cosine);
  constexpr double least_rad = 1e-4;
  if (told_rad < least_rad) {
    return;
  }
  f.amplitude_rad = told_rad;
  f.amplitude_ratio = moved_rad / told_rad;
  if (moved_rad > 0.05 * told_rad) {
    const double lag_rad = std::atan2(command->cosine, command->sine) - std::atan2(encoder->cosine, encoder->sine);
    f.phase_lag_rad = lag_rad - turn_rad * std::floor(lag_rad / turn_rad);
  }
}

void add_sent_wave(const CanardTrace& trace, const Exercise& exercise, std::size_t canard, Figures& f) {
  const std::optional<SentWave> sent = sent_wave(trace, exercise, canard);
  if (!sent) {
    return;
  }
  f.wave_difference = sent->difference;
  f.longest_standstill_s = tick_s * static_cast<double>(sent->longest_standstill);
  if (const auto asked = phasor(sent->asked_rad, swung_in(sine_window(trace)), exercise.wave()->frequency_hz)) {
    f.asked_amplitude_rad = std::hypot(asked->sine, asked->cosine);
  }
}

}  // namespace fantail::bench
