// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "hal/clock.hpp"
#include "json/value.hpp"
#include "telemetry/messages.hpp"

namespace fantail::live {

/// What the page plots, in degrees, m and m/s, in the order of the page's script.
inline constexpr std::size_t signals = 7;
/// Roll angle, reference, roll rate, command, mean of the canards, height, speed.
using Sample = std::array<std::optional<double>, signals>;
/// The roll angle that the law turns to, rad: only in Controlling is there one.
[[nodiscard]] std::optional<double> reference_in_force(const telemetry::State& state);
[[nodiscard]] Sample sample_of(const telemetry::State& state, const std::optional<double>& canard_rad);

/// What is to be plotted, thinned without losing a peak: each stretch of 25 ms becomes two points, the lowest and the
/// highest value of every signal in the order of their time.
class PlotHistory {
 public:
  static constexpr hal::Microseconds stretch{25'000};
  static constexpr hal::Microseconds half_a_minute{30'000'000};

  explicit PlotHistory(std::size_t signal_count, hal::Microseconds kept = half_a_minute)
      : signal_count_{signal_count}, kept_{kept} {}

  /// By the rocket's clock. One that is not behind the newest is left out. A value of each signal.
  void add(hal::Microseconds time, std::span<const std::optional<double>> sample);
  void clear();

  /// Of each stretch since the last call [begin in ms, end in ms, value, value, value, ...]: of each signal two, in
  /// hundredths or null.
  [[nodiscard]] json::Value take_news();
  /// The same of all that is kept, up to what take_news() has told.
  [[nodiscard]] json::Value all_told() const;

 private:
  struct Extremes {
    double low = 0.0;
    double high = 0.0;
    bool low_came_first = true;
  };
  struct Stretch {
    hal::Microseconds begin{};
    hal::Microseconds end{};
    std::vector<std::optional<Extremes>> extremes{};
  };
  static void widen(std::optional<Extremes>& extremes, double value);
  static json::Value json_of(const Stretch& one);

  std::size_t signal_count_;
  hal::Microseconds kept_;
  std::deque<Stretch> stretches_;
  std::size_t untold_ = 0;  ///< so many of them, the newest
};

}  // namespace fantail::live
