// SPDX-License-Identifier: MIT
#include "report/activity.hpp"

#include <algorithm>
#include <cmath>

#include "text/degrees.hpp"

namespace fantail::report {
namespace {

constexpr double window_s = 1.0;
constexpr double window_step_s = 0.5;
constexpr double least_swing_rad = text::radians(1.0);
constexpr int least_swings = 3;
// The second half of a window against its first: less is a swing that dies away.
constexpr double lasts = 0.7;
constexpr double clock_tolerance_s = 1e-6;

}  // namespace

struct OscillationWatch::Ends {
  double lowest_rad;
  double highest_rad;
  [[nodiscard]] double middle_rad() const { return 0.5 * (lowest_rad + highest_rad); }
  [[nodiscard]] double swing_rad() const { return 0.5 * (highest_rad - lowest_rad); }
};

OscillationWatch::Ends OscillationWatch::ends(Samples samples, double Sample::* angle) {
  Ends e{samples.front().*angle, samples.front().*angle};
  for (const Sample& sample : samples) {
    e.lowest_rad = std::min(e.lowest_rad, sample.*angle);
    e.highest_rad = std::max(e.highest_rad, sample.*angle);
  }
  return e;
}

/// Whole swings; empty when there are too few. A swing counts when it comes to half of the largest on either side, so
/// that noise about the middle is none.
std::optional<OscillationWatch::Swings> OscillationWatch::count_swings(Samples window, const Ends& e) {
  const double threshold_rad = 0.5 * e.swing_rad();
  std::optional<double> first_s;
  double last_s = 0.0;
  int swings = -1;
  bool below = false;
  for (const Sample& sample : window) {
    const double away_rad = sample.angle_rad - e.middle_rad();
    below = below || away_rad < -threshold_rad;
    if (below && away_rad > threshold_rad) {
      below = false;
      first_s = first_s.value_or(sample.time_s);
      last_s = sample.time_s;
      ++swings;
    }
  }
  if (swings < least_swings - 1 || !first_s || last_s <= *first_s) {
    return std::nullopt;
  }
  return Swings{
      .begin_s = *first_s, .end_s = last_s, .count = swings, .lowest_rad = e.lowest_rad, .highest_rad = e.highest_rad};
}

std::optional<OscillationWatch::Swings> OscillationWatch::look_at(Samples window) {
  const double before_rad = ends(window.first(window.size() / 2)).swing_rad();
  const double after_rad = ends(window.last(window.size() / 2)).swing_rad();
  if (std::min(before_rad, after_rad) < least_swing_rad || after_rad < lasts * before_rad) {
    return std::nullopt;
  }
  // Encoders can be noisy. A loop that oscillates does so in what it commands, too.
  if (!window.front().truth_is_known && ends(window, &Sample::command_rad).swing_rad() < least_swing_rad) {
    return std::nullopt;
  }
  return count_swings(window, ends(window));
}

/// Each window that the quiet samples fill; one is full when there is a sample beyond it.
void OscillationWatch::look_through() {
  const auto at = [this](double time_s) {
    return std::ranges::lower_bound(quiet_, time_s - clock_tolerance_s, {}, &Sample::time_s);
  };
  while (!quiet_.empty()) {
    const double from_s = quiet_.front().time_s;
    if (quiet_.back().time_s < from_s + window_s - clock_tolerance_s) {
      return;
    }
    if (const auto found = look_at({quiet_.begin(), at(from_s + window_s)})) {
      first_seen_s_ = first_seen_s_.value_or(from_s);
      if (!widest_ || found->highest_rad - found->lowest_rad > widest_->highest_rad - widest_->lowest_rad) {
        widest_ = found;
      }
    }
    quiet_.erase(quiet_.begin(), std::max(quiet_.begin() + 1, at(from_s + window_step_s)));
  }
}

void OscillationWatch::add(const flight::Row& row) {
  const bool begins = !reference_rad_;
  if (begins || row.excitation_rad != 0.0 || row.reference_rad != *reference_rad_) {
    settles_at_s_ = row.time_s + settling_time_s_;
    quiet_.clear();
  }
  reference_rad_ = row.reference_rad;
  if (row.time_s < settles_at_s_ - clock_tolerance_s) {
    return;
  }
  const bool is_true = row.truth && std::isfinite(row.truth->canard_rad);
  quiet_.push_back({.time_s = row.time_s,
                    .angle_rad = is_true ? row.truth->canard_rad : row.canard_rad.value_or(row.command_rad),
                    .command_rad = row.command_rad,
                    .truth_is_known = row.truth.has_value()});
  look_through();
}

std::optional<Oscillation> OscillationWatch::found(const flight::Clock& clock) const {
  if (!widest_) {
    return std::nullopt;
  }
  return Oscillation{.from_s = clock(*first_seen_s_),
                     .frequency_hz = widest_->count / (clock(widest_->end_s) - clock(widest_->begin_s)),
                     .lowest_rad = widest_->lowest_rad,
                     .highest_rad = widest_->highest_rad};
}

}  // namespace fantail::report
