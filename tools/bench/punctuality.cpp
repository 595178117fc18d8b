// SPDX-License-Identifier: MIT
#include "bench/punctuality.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "bench/perform.hpp"
#include "bench/trace.hpp"
#include "text/number.hpp"

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
constexpr hal::Microseconds longest_look{longest_look_ms * 1'000};

std::int64_t milliseconds(hal::Microseconds time) { return time.count() / 1'000; }

}  // namespace

void Punctuality::give_up_too_slow(const std::string& why) const {
  throw TooSlow{
      fmt::format("this PC was too slow, so the canards are not judged: {}. Its longest pause between two reads of the "
                  "bus was {} ms. End other programs and try again",
                  why, milliseconds(longest_pause_))};
}

// What is known of the cause, and no more.
void Punctuality::give_up(const std::string& why) const {
  if (longest_pause_ > longest_look) {
    give_up_too_slow(why);
  }
  if (longest_silence_ > longest_look) {
    throw Unmeasured{
        fmt::format("no report of the rocket arrived for {} ms while this PC read the bus, so the canards are not "
                    "judged: {}. Did the avionics or its node stop, or was the cable off? Correct that and try again",
                    milliseconds(longest_silence_), why)};
  }
  throw Unmeasured{
      fmt::format("the rocket's reports arrived late or with gaps, so the canards are not judged: {}. This PC never "
                  "paused for more than {} ms. Check cable, terminators and adapter, and try again",
                  why, milliseconds(longest_pause_))};
}

void Punctuality::begin_look(hal::Microseconds now) {
  longest_pause_ = std::max(longest_pause_, now - std::exchange(last_look_, now));
  longest_silence_ = std::max(longest_silence_, now - last_heard_);
}

void Punctuality::note(const link::Tick& tick) {
  if (const std::int64_t gap_ms = tick.number - last_.value_or(tick.number - 1) - 1; gap_ms > longest_gap_ms) {
    give_up(fmt::format("{} ms of the rocket's reports are missing in a row", gap_ms));
  }
  last_ = tick.number;
  last_heard_ = last_look_;
  if (!first_) {
    first_ = tick.number;
  }
  received_ += 1;
}

void Punctuality::end_look() {
  if (const std::uint32_t overrun = link_.overrun() - overrun_before_; overrun > 0) {
    const std::string why = text::counted(overrun, "frame was", "frames were") + " lost in a full buffer";
    longest_silence_ > longest_look ? give_up(why) : give_up_too_slow(why);
  }
  if (const auto uncounted_ms = link_.uncounted_ms(); uncounted_ms && uncounted_before_ms_) {
    if (const std::int64_t unseen = *uncounted_ms - *uncounted_before_ms_; std::abs(unseen) > unseen_ms) {
      give_up(
          fmt::format("the rocket's clock and the numbers of its reports drifted apart by {} ms", std::abs(unseen)));
    }
  }
  if (last_ && last_at_look_ && *last_ - *last_at_look_ > longest_look_ms && ++long_looks_ > most_long_looks) {
    give_up(fmt::format("more than {} ms of the rocket's reports came at once, {} times; at most {} times are allowed",
                        longest_look_ms, long_looks_, most_long_looks));
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
