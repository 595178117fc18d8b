// SPDX-License-Identifier: MIT
#include "report/timeline.hpp"

#include <algorithm>
#include <cmath>

#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

// More labelled steps than this would hide each other.
constexpr std::size_t most_step_labels = 3;

std::vector<EventMark> reference_steps(const flight::Flight& flight) {
  std::vector<EventMark> steps;
  const flight::Row* before = nullptr;
  for (const flight::Row& row : flight.rows) {
    if (row.phase != core::Phase::controlling || !std::isfinite(row.reference_rad)) {
      continue;
    }
    if (before != nullptr && row.reference_rad != before->reference_rad) {
      const std::string sign = row.reference_rad > 0.0 ? "+" : "";
      steps.push_back({row.time_s, "step to " + sign +
                                       text::with_minus(text::brief(text::degrees(row.reference_rad), 1)) + "\u00b0"});
    }
    before = &row;
  }
  if (steps.size() > most_step_labels) {
    for (std::size_t i = 1; i < steps.size(); ++i) {
      steps[i].label.clear();
    }
    steps.front().label = "steps";
  }
  return steps;
}

}  // namespace

std::vector<PhaseBand> phase_bands(const flight::Flight& flight) {
  std::vector<PhaseBand> bands;
  for (const flight::Row& row : flight.rows) {
    if (bands.empty() || bands.back().phase != row.phase) {
      if (!bands.empty()) {
        bands.back().end_s = row.time_s;
      }
      bands.push_back({row.phase, row.time_s, row.time_s});
    }
    bands.back().end_s = row.time_s;
  }
  return bands;
}

std::vector<EventMark> event_marks(const flight::Flight& flight) {
  std::vector<EventMark> marks = reference_steps(flight);  // by time, and kept so
  const flight::Events& e = flight.events;
  const auto mark = [&marks](const std::optional<double>& time_s, const char* label) {
    if (time_s) {
      marks.insert(std::ranges::upper_bound(marks, *time_s, {}, &EventMark::time_s), {*time_s, label});
    }
  };
  mark(e.liftoff_s, "lift-off");
  mark(e.detected_s, "detected");
  mark(e.guide_clear_s, "off the guide");
  mark(e.control_start_s, "control");
  mark(e.burnout_s, "burn-out");
  mark(e.apogee_s, "apogee");
  if (!e.apogee_s || (e.control_end_s && *e.control_end_s < *e.apogee_s - 0.2)) {
    mark(e.control_end_s, "control ends");
  }
  return marks;
}

Window plot_window(const flight::Flight& flight) {
  if (flight.rows.empty()) {
    return {};
  }
  Window window{flight.rows.front().time_s, flight.rows.back().time_s};
  const flight::Events& e = flight.events;
  if (const auto start = e.liftoff_s ? e.liftoff_s : e.control_start_s) {
    window.begin_s = std::max(window.begin_s, *start - 1.0);
  }
  if (e.control_end_s || e.apogee_s) {
    const double over_s = std::max(e.control_end_s.value_or(window.begin_s), e.apogee_s.value_or(window.begin_s));
    window.end_s = std::min(window.end_s, over_s + 0.5);
  }
  return window;
}

std::span<const flight::Row> rows_between(const flight::Flight& flight, double begin_s, double end_s) {
  const auto first = std::ranges::lower_bound(flight.rows, begin_s, {}, &flight::Row::time_s);
  const auto last = std::ranges::upper_bound(first, flight.rows.end(), end_s, {}, &flight::Row::time_s);
  return {first, last};
}

}  // namespace fantail::report
