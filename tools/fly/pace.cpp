// SPDX-License-Identifier: MIT
#include "fly/pace.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/core.h>

namespace fantail::fly {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds tick{1};
constexpr milliseconds most_debt{10};
constexpr milliseconds worth_a_word{1'000};
constexpr milliseconds window{5'000};

double seconds(Pace::Duration duration) { return std::chrono::duration<double>{duration}.count(); }

}  // namespace

Pace::Time Pace::next(Time now) {
  late_ += now > due_ ? 1 : 0;
  if (now > due_ + most_debt) {
    // With a pause, in which a bench can speak however busy this PC is.
    leave_out(now + tick - due_);
    due_ = now + tick;
  }
  if (now - window_begin_ >= window) {
    close_window(now);
  }
  const Time begin = due_;
  due_ += tick;
  return begin;
}

void Pace::leave_out(Duration time) {
  left_out_ += time;
  if (time > worth_a_word) {
    messages_ += fmt::format(
        "the rocket stood still for {:.1f} s, because this PC slept or was busy; simulated time continues from here\n",
        seconds(time));
  }
  if (time > window) {
    window_begin_ += time;  // that was no matter of pace
  } else {
    left_out_in_window_ += time;
  }
}

std::uint32_t Pace::ticks_left_out() const {
  constexpr std::int64_t most = std::numeric_limits<std::uint32_t>::max();
  return static_cast<std::uint32_t>(std::min<std::int64_t>(left_out_ / tick, most));
}

// Less than half of the time was lived through: whoever waits for the rocket waits more than twice as long.
void Pace::close_window(Time now) {
  const Duration passed = now - window_begin_;
  if (2 * left_out_in_window_ > passed) {
    messages_ += fmt::format("this PC is too busy: of the last {:.1f} s only {:.1f} s were simulated\n",
                             seconds(passed), seconds(passed - left_out_in_window_));
  }
  window_begin_ = now;
  left_out_in_window_ = {};
}

std::string Pace::take_messages() { return std::exchange(messages_, {}); }

}  // namespace fantail::fly
