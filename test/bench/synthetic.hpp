// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "../core/random_stream.hpp"
#include "bench/exercise.hpp"
#include "degree.hpp"
#include "link/avionics_link.hpp"

namespace fantail::bench {

inline Bounds six_degrees(double limit_deg = 6.0, double centre_deg = 0.0) {
  Bounds b;
  b.limit_rad.fill(limit_deg * degree);
  b.centre_rad.fill(centre_deg * degree);
  return b;
}

/// Roughly normal, standard deviation 1 and no tails worth speaking of: the sum of twelve even numbers.
inline double bell(core::RandomStream& random) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) {
    sum += random.unit();
  }
  return sum;
}

/// A canard in closed form: a first-order lag of a command that is held for each millisecond, then play, then gain and
/// offset, then the encoder's noise and the bus's steps of 0.01 deg.
struct IdealCanard {
  double lag_s = 0.020;
  double play_rad = 0.0;
  double gain = 1.0;
  double offset_rad = 0.0;
  double noise_rad = 0.0;
  double dropout_share = 0.0;
  double fastest_rad_s = 1e9;   ///< a plain rate limit
  std::size_t answers_to = 99;  ///< the canard whose command it follows; its own by default
  bool quantised = true;

  double lagged_rad = 0.0;
  double shaft_rad = 0.0;

  void move(double command_rad) {
    const double wanted = (command_rad - lagged_rad) * (1.0 - std::exp(-0.001 / lag_s));
    lagged_rad += std::clamp(wanted, -0.001 * fastest_rad_s, 0.001 * fastest_rad_s);
    shaft_rad = std::clamp(shaft_rad, lagged_rad - play_rad / 2, lagged_rad + play_rad / 2);
  }
  [[nodiscard]] std::optional<double> read(core::RandomStream& random) const {
    const double noise = noise_rad * bell(random);
    if (random.chance(dropout_share)) {
      return std::nullopt;
    }
    const double angle_rad = gain * shaft_rad + offset_rad + noise;
    const double step = 0.01 * degree;
    return quantised ? std::clamp(std::round(angle_rad / step), -2047.0, 2047.0) * step : angle_rad;
  }
};

struct Bench {
  Each<IdealCanard> canards{};
  std::uint32_t seed = 1;
  std::int64_t first_tick = 1000;
  int marks_late_ms = 0;  ///< how late, and by how much at random, a stretch is marked
  int marks_scatter_ms = 0;
  double lost_share = 0.0;
  double commands_beyond_rad = 0.0;  ///< an avionics that does not keep its limit
  bool reports_limited = true;
  int requests_every_ms = 1;
  double pace = 1.0;  ///< of the exercise, by the rocket's clock: a slow PC falls behind

  link::Recording record(const Exercise& exercise) {
    core::RandomStream random{seed};
    link::Recording recording;
    for (std::size_t i = 0; i < canards.size(); ++i) {
      canards[i].lagged_rad = canards[i].shaft_rad = exercise.bounds().centre_rad[i];
    }
    std::size_t marked = 0;
    Each<double> command = exercise.bounds().centre_rad;
    const int ticks = static_cast<int>(std::lround(exercise.duration_s() * 1000.0 / pace));
    for (int t = 0; t < ticks; ++t) {
      link::Tick tick{.number = first_tick + t};
      const auto asked = exercise.asked(0.001 * pace * (t - t % requests_every_ms));
      for (std::size_t i = 0; i < canards.size(); ++i) {
        tick.encoder_rad[i] = canards[i].read(random);  // read before the servos are told
      }
      for (std::size_t i = 0; i < canards.size(); ++i) {
        const double wanted = asked[i] ? static_cast<double>(asked[i]->radians()) : exercise.bounds().centre_rad[i];
        const double limit = exercise.bounds().limit_rad[i] + commands_beyond_rad;
        command[i] = std::clamp(wanted, -limit, limit);
        tick.command_rad[i] = std::round(command[i] / (0.01 * degree)) * 0.01 * degree;
        tick.limited[i] = reports_limited && std::abs(wanted - command[i]) > 1e-9;
      }
      for (std::size_t i = 0; i < canards.size(); ++i) {
        canards[i].move(command[canards[i].answers_to < 4 ? canards[i].answers_to : i]);
      }
      const int late = marks_late_ms + (marks_scatter_ms > 0 ? random.whole(0, marks_scatter_ms) : 0);
      marked = std::max(marked, exercise.stretch_at(0.001 * pace * (t - late)));
      tick.stretch = marked;
      if (!random.chance(lost_share)) {
        recording.add(tick);
      }
    }
    return recording;
  }
};

}  // namespace fantail::bench
