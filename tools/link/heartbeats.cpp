// SPDX-License-Identifier: MIT
#include "link/heartbeats.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace fantail::link {
namespace {

// One rocket's are 100 ms apart, give or take ticks that came late.
constexpr std::int64_t shortest_step_ms = 80;
constexpr std::int64_t usual_step_ms = 150;
// Three lost ones, and a little. What is farther on may be another clock, and is one of its own at first.
constexpr std::int64_t longest_step_ms = 410;
// A bus may give a frame twice when its last bit is disturbed, and that is rare.
constexpr int most_too_soon = 1;
// Heartbeats: of a clock that has been silent for so many nothing is concluded any more.
constexpr std::int64_t forgotten_after = 20;
// A rocket that was switched on again has been on for no longer than since its last heartbeat before that, and the time
// that an adapter keeps a frame.
constexpr std::int64_t longest_way_ms = 1'000;

}  // namespace

bool Heartbeats::Clock::goes_on(std::uint32_t uptime_ms) const {
  const std::int64_t step = uptime.step_to(uptime_ms);
  return step >= shortest_step_ms && step <= longest_step_ms;
}

// The newest clock if it goes on as usual, else the one that is nearest.
Heartbeats::Clock* Heartbeats::clock_of(std::uint32_t uptime_ms) {
  Clock* nearest = nullptr;
  for (auto clock = clocks_.rbegin(); clock != clocks_.rend(); ++clock) {
    if (!clock->goes_on(uptime_ms)) {
      continue;
    }
    if (clock == clocks_.rbegin() && clock->uptime.step_to(uptime_ms) <= usual_step_ms) {
      return &*clock;
    }
    if (nearest == nullptr || clock->uptime.step_to(uptime_ms) < nearest->uptime.step_to(uptime_ms)) {
      nearest = &*clock;
    }
  }
  return nearest;
}

bool Heartbeats::hear(std::uint32_t uptime_ms, std::optional<std::int64_t> since_last_ms) {
  if (newest_ && since_last_ms && newest_->is_back(uptime_ms) && uptime_ms > *since_last_ms + longest_way_ms) {
    found(newest_->total(), uptime_ms);
  }
  newest_.emplace(uptime_ms);
  std::erase_if(clocks_, [this](const Clock& clock) { return count_ - clock.last > forgotten_after; });
  Clock* const clock = clock_of(uptime_ms);
  if (clock == nullptr && is_too_soon(uptime_ms)) {
    return false;
  }
  count_ += 1;
  if (clock == nullptr) {
    clocks_.push_back({.uptime = UptimeCounter{uptime_ms}, .last = count_});
    if (!followed_) {
      followed_.emplace(uptime_ms);
    }
    return count_ == 1;
  }
  if (clock->last + 1 < count_) {  // another one's came between two of this one
    found(clock->uptime.total(), clocks_.back().uptime.total());
  }
  clock->uptime.read(uptime_ms);
  clock->last = count_;
  if (followed_->is_back(uptime_ms)) {  // switched on again
    followed_ = clock->uptime;
  }
  followed_->read(uptime_ms);
  std::rotate(clocks_.begin() + (clock - clocks_.data()), clocks_.begin() + (clock - clocks_.data()) + 1,
              clocks_.end());
  return true;
}

// Sooner after the last than one rocket sends it.
bool Heartbeats::is_too_soon(std::uint32_t uptime_ms) {
  for (const Clock& clock : clocks_) {
    if (const std::int64_t step = clock.uptime.step_to(uptime_ms); step < shortest_step_ms) {
      too_soon_ = count_ - last_too_soon_ > forgotten_after ? 1 : too_soon_ + 1;
      last_too_soon_ = count_;
      if (too_soon_ > most_too_soon) {
        found(clock.uptime.total(), clock.uptime.total() + step);
      }
      return true;
    }
  }
  return false;
}

void Heartbeats::found(std::int64_t one_ms, std::int64_t other_ms) {
  if (!two_rockets_) {
    two_rockets_ = fmt::format(
        "two rockets, or a device that imitates one, report on this bus, with uptimes of {:.1f} s and {:.1f} s; "
        "disconnect all but one",
        1e-3 * static_cast<double>(one_ms), 1e-3 * static_cast<double>(other_ms));
  }
}

}  // namespace fantail::link
