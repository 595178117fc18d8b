// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace fantail::tool {

/// One line on a terminal for work that takes longer than half a second: how far, how fast, how long still. Where
/// standard error is not a terminal, a line of its own every ten seconds.
class Progress {
 public:
  /// What there is to go through, and how its rate is said: " x real time" for simulated seconds.
  struct Measure {
    std::string_view unit;
    std::string_view rate;
    std::optional<double> total;  ///< where it is known beforehand
  };
  Progress(std::string what, const Measure& measure);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(double done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  Measure measure_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_;
};

}  // namespace fantail::tool
