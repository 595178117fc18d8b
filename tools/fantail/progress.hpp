// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace fantail::tool {

/// One line on a terminal for work that takes longer than half a second: how far, how fast, how long still. Silent when
/// standard error is not a terminal.
class Progress {
 public:
  /// `total_s`: simulated seconds to go through, where they are known beforehand.
  Progress(std::string what, std::optional<double> total_s);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(double done_s);

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  std::optional<double> total_s_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::milliseconds{500};
};

}  // namespace fantail::tool
