// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

#include "text/error.hpp"

namespace fantail::tool {

/// Ctrl-C, a request to terminate, or a terminal that was closed. Work is given up between two steps, never in the
/// middle of writing results.
class Interrupted : public text::Error {
 public:
  explicit Interrupted(const std::string& what = "interrupted; nothing was written")
      : Error{text::ErrorKind::interrupted, what} {}
};

/// From here on the signals only set a mark.
void catch_interrupts();

/// For a program that takes the signals itself: called wherever the mark is looked at, it throws when there was one.
void ask_for_interrupts(void (*give_up)());

/// Throws Interrupted when the mark is set.
void give_up_if_interrupted();

/// True once for every interrupt: for work that has to be ended in order, and cannot when the mark stays.
[[nodiscard]] bool take_interrupt();

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

/// "flying tasha3_launch2: 12 of 60 runs, 7.5 a second, 6 s to go"; without a rate as long as nothing is done.
[[nodiscard]] std::string progress_line(std::string_view what, const Progress::Measure& measure, double done,
                                        double elapsed_s);

/// "log export: replaying (part 2 of 3), 4 s"; work in one part has no number.
[[nodiscard]] std::string chapter_line(std::string_view what, std::string_view name, std::size_t chapter,
                                       std::size_t count, double elapsed_s);

/// The same for work in a few parts that cannot say how far they are: "log export: replaying (part 2 of 3), 4 s". A
/// thread of its own shows it, because the work does not come by.
class Chapters {
 public:
  Chapters(std::string what, std::size_t count, std::string first);
  ~Chapters() { end(); }
  Chapters(const Chapters&) = delete;
  Chapters& operator=(const Chapters&) = delete;

  /// The next one has begun.
  void next(std::string name);
  /// The same one, named more exactly.
  void now(std::string name);
  /// All are done: nothing is shown any more.
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  void show_until(const std::stop_token& stop);

  std::string what_;
  std::size_t count_;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;  ///< of number and name of the chapter
  std::condition_variable_any wake_;
  std::size_t chapter_ = 1;
  std::string name_;
  std::jthread shows_;
};

}  // namespace fantail::tool
