// SPDX-License-Identifier: MIT
#include "timeline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fantail::board {

double Timeline::time_of(std::uint64_t counts) const {
  return base_s_ + static_cast<double>(counts - base_counts_) / (counts_per_cycle * frequency_hz_);
}

std::uint64_t Timeline::counts_at(double time_s) const {
  const double counts = std::ceil((time_s - base_s_) * counts_per_cycle * frequency_hz_);
  return counts <= 0 ? base_counts_ : base_counts_ + static_cast<std::uint64_t>(counts);
}

void Timeline::set_frequency_hz(double frequency_hz) {
  if (frequency_hz == frequency_hz_) {
    return;
  }
  base_s_ = now_s();
  base_counts_ = counts_;
  frequency_hz_ = frequency_hz;
  for (Entry& entry : entries_) {
    if (entry.at_counts && entry.time_s) {
      entry.at_counts = counts_at(*entry.time_s);
    }
  }
  find_next();
}

void Timeline::spend_until(double time_s) { counts_ = std::max(counts_, counts_at(time_s)); }

Timeline::Event Timeline::add(std::function<void()> what) {
  entries_.push_back({.what = std::move(what), .time_s = {}, .at_counts = {}});
  return entries_.size() - 1;
}

void Timeline::schedule(Event event, double time_s) {
  entries_[event].time_s = time_s;
  entries_[event].at_counts = counts_at(time_s);
  find_next();
}

void Timeline::schedule_at_counts(Event event, std::uint64_t counts) {
  entries_[event].time_s.reset();
  entries_[event].at_counts = counts;
  find_next();
}

void Timeline::cancel(Event event) {
  entries_[event].at_counts.reset();
  find_next();
}

void Timeline::find_next() {
  next_ = UINT64_MAX;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].at_counts && *entries_[i].at_counts < next_) {
      next_ = *entries_[i].at_counts;
      next_entry_ = i;
    }
  }
}

void Timeline::run() {
  while (is_due()) {
    const std::size_t entry = next_entry_;
    entries_[entry].at_counts.reset();
    find_next();
    entries_[entry].what();
  }
}

void Timeline::sleep() {
  counts_ = std::max(counts_, next_);
  run();
}

}  // namespace fantail::board
