// SPDX-License-Identifier: MIT
#include "bench/punctuality.hpp"

#include <cstdlib>
#include <string>

#include <fmt/core.h>

#include "bench/too_slow.hpp"
#include "bench/trace.hpp"

namespace fantail::bench {
namespace {

// Requests are as old as the time between two looks. docs/bench.md has the verdicts measured against it: up to here
// they are right. A few longer looks do no harm, because an angle is held for longer than that; the avionics itself
// ends a session after 100 ms.
constexpr std::int64_t longest_look_ms = 60;
constexpr int most_long_looks = 10;
// A gap hides how a canard moved, and a step could lie in it.
constexpr std::int64_t longest_gap_ms = 20;
// Ticks lost unseen come in sixteens; heartbeats are a tick early or late.
constexpr std::int64_t unseen_ms = 8;

[[noreturn]] void give_up(const std::string& why) {
  throw TooSlow{"this PC was too slow; nothing is said of the canards: " + why +
                ". End other programs, then do it again"};
}

}  // namespace

void Punctuality::note(const link::Tick& tick) {
  if (const std::int64_t gap_ms = tick.number - last_.value_or(tick.number - 1) - 1; gap_ms > longest_gap_ms) {
    give_up(fmt::format("it missed {} ms of the rocket's reports", gap_ms));
  }
  last_ = tick.number;
  if (!first_) {
    first_ = tick.number;
  }
  received_ += 1;
}

void Punctuality::end_look() {
  if (const std::uint32_t overrun = link_.overrun() - overrun_before_; overrun > 0) {
    give_up(fmt::format("{} frames were lost because they were not read in time", overrun));
  }
  if (const auto uncounted_ms = link_.uncounted_ms(); uncounted_ms && uncounted_before_ms_) {
    if (const std::int64_t unseen = *uncounted_ms - *uncounted_before_ms_; std::abs(unseen) > unseen_ms) {
      give_up(fmt::format("by the rocket's clock it missed {} ms of the rocket's reports", std::abs(unseen)));
    }
  }
  if (last_ && last_at_look_ && *last_ - *last_at_look_ > longest_look_ms && ++long_looks_ > most_long_looks) {
    give_up(fmt::format("it read nothing for more than {} ms, {} times; at most {} times are allowed", longest_look_ms,
                        long_looks_, most_long_looks));
  }
  last_at_look_ = last_;
}

void Punctuality::end() const {
  if (!first_) {
    return;
  }
  const std::int64_t all = *last_ - *first_ + 1;
  if (const std::int64_t lost = all - received_;
      static_cast<double>(lost) > most_lost_share * static_cast<double>(all)) {
    give_up(fmt::format("{} of {} ms of the rocket's reports are missing", lost, all));
  }
}

}  // namespace fantail::bench
