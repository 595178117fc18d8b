// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "bench/exercise.hpp"
#include "bench/sheet.hpp"
#include "fantail/page_output.hpp"
#include "link/avionics_link.hpp"

namespace fantail::tool {

/// The page of an exercise: angles while canards move, and the sheet as far as it is filled. Without the option it does
/// nothing. What takes time is done in a thread of its own: the rocket waits for heartbeats.
class BenchPage {
 public:
  /// Says on standard error where the page is. Throws std::runtime_error when it cannot be there. `source` is the
  /// rocket, for people.
  BenchPage(const PageOptions& options, const std::string& source);
  ~BenchPage();
  BenchPage(const BenchPage&) = delete;
  BenchPage& operator=(const BenchPage&) = delete;

  /// Before anything moves. Throws Interrupted.
  void wait_for_viewer() const;
  void begin(const bench::Exercise& exercise, const sim::CanardTolerances& tolerances, const bench::Heading& heading);
  /// Of every tick; it costs a lock and a copy.
  void take(const link::Tick& tick);
  /// So much of the exercise is done.
  void progress(double done_s);
  /// It ends before its end, and the page shows why. `turns_count`: the results of finished turns stay.
  /// Nothing is done when the end has been shown.
  void give_up(const std::string& why, bool turns_count);
  /// The whole sheet is shown; one sentence on the viewers, empty without the option.
  std::string finish(const bench::Sheet& sheet, const link::Recording& recording, const bench::Exercise& exercise);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace fantail::tool
