// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace fantail::fly {

/// When the ticks of an avionics in real time begin, on a PC that may be busy. A tick that is late by no more than 10
/// ms is made up for; what is later is left out, and the rocket's time goes slower than the PC's. Otherwise a PC that
/// held up both programs for a moment would end a bench session: of the bench's heartbeats, one in 20 ms, none could
/// come while 100 ms are lived through at once.
class Pace {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Duration = std::chrono::steady_clock::duration;

  explicit Pace(Time begin) : due_{begin}, window_begin_{begin} {}

  /// When the next tick is to begin; `now` or earlier: at once.
  [[nodiscard]] Time next(Time now);

  /// What a person should know by now of a PC that does not keep pace; empty most of the time. To be asked after
  /// next().
  [[nodiscard]] std::string take_messages();

  /// Ticks that ended after the next one was due.
  [[nodiscard]] std::int64_t late() const { return late_; }
  [[nodiscard]] Duration left_out() const { return left_out_; }
  [[nodiscard]] std::uint32_t ticks_left_out() const;

 private:
  void leave_out(Duration time);
  void close_window(Time now);

  Time due_;
  std::int64_t late_ = 0;
  Duration left_out_{};
  Time window_begin_;
  Duration left_out_in_window_{};
  std::string messages_;
};

}  // namespace fantail::fly
