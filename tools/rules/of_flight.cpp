// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "rules/burnout.hpp"
#include "rules/departure.hpp"
#include "rules/figures.hpp"
#include "rules/record.hpp"
#include "rules/return_to_trim.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::rules {
namespace {

using Rows = std::span<const flight::Row>;

bool has_truth(const flight::Flight& flight) { return !flight.rows.empty() && flight.rows.front().truth.has_value(); }

/// Up to the end of the ascent: later a parachute opens, and an estimate is worth nothing.
Rows ascent(const flight::Flight& flight) {
  const auto end_s = end_of_ascent(flight);
  const auto end = std::ranges::find_if(
      flight.rows, [&](const flight::Row& row) { return row.time_s > end_s.value_or(row.time_s); });
  return Rows{flight.rows}.first(static_cast<std::size_t>(end - flight.rows.begin()));
}

/// The largest value of something between lift-off and the end of the ascent, and when.
struct Peak {
  double value = 0.0;
  double time_s = 0.0;
  bool is_last = true;  ///< it still grew
};
template <typename Value>
Peak peak(Rows rows, const Value& value_of) {
  Peak peak{.value = -infinity};
  for (const flight::Row& row : rows) {
    if (row.time_s >= 0.0 && value_of(row) > peak.value) {
      peak = {.value = value_of(row), .time_s = row.time_s};
    }
  }
  peak.is_last = !rows.empty() && rows.back().time_s <= peak.time_s;
  return peak;
}

class OfFlight {
 public:
  OfFlight(const flight::Flight& flight, const sim::Atmosphere& atmosphere, bool is_log,
           const std::optional<double>& motor_burns_s)
      : flight_{flight},
        atmosphere_{atmosphere},
        is_log_{is_log},
        motor_burns_s_{motor_burns_s},
        rows_{ascent(flight)},
        is_simulated_{has_truth(flight)},
        missing_{is_log ? holes_of_ascent(flight) : std::vector<Hole>{}},
        control_{is_log ? control_in_log(flight) : ControlInLog{}} {}

  Findings take() && {
    add_motion();
    const Finding burnout = burnout_s(flight_, rows_, {.is_log = is_log_, .is_whole = is_whole()}, motor_burns_s_);
    add("burnout_s", burnout.known, burnout.how);
    add_control_start();
    add_canards();
    return std::move(all_);
  }

 private:
  void add(std::string_view name, std::optional<Known> known, std::string how = {}) {
    if (const auto* number = known ? std::get_if<Number>(&*known) : nullptr) {
      known = can_be_finite(*number) ? known : std::nullopt;
    }
    all_["flight." + std::string{name}] = {std::move(known), std::move(how)};
  }

  /// In a log that ends before apogee, or whose accelerometer was at the end of its range, it may have been larger.
  void add_peak(std::string_view name, const Peak& peak, bool is_open) {
    const bool is_bound = flight_.unmeasured.speed_bound_from_s && !is_simulated_;
    add(name, Number{peak.value, is_open || is_bound || !missing_.empty() ? infinity : peak.value},
        with_missing(is_bound ? "estimated; an accelerometer was at the end of its range" : estimated(), missing_));
  }
  /// Of what may have been at a seen time or in a hole.
  static Number at_or_in(double seen_s, const std::vector<Hole>& hidden) {
    Number all = exactly(seen_s);
    for (const auto& [from_s, to_s] : hidden) {
      all = {std::min(all.low, from_s), std::max(all.high, to_s)};
    }
    return all;
  }
  [[nodiscard]] std::string estimated() const { return is_simulated_ ? "" : "as the avionics estimated it"; }

  [[nodiscard]] std::string estimated_height(const flight::Row& row) const {
    return estimated() + (!is_simulated_ && row.height_error_m ? ", within the usual error of an accelerometer" : "");
  }

  void add_motion() {
    const Peak height = peak(rows_, height_m);
    add_peak("apogee_m", height, !is_whole());
    const Peak speed = peak(rows_, speed_m_s);
    add_peak("top_speed_m_s", speed, speed.is_last);
    add_peak(
        "largest_mach",
        peak(rows_,
             [this](const flight::Row& row) { return speed_m_s(row) / atmosphere_.speed_of_sound_m_s(height_m(row)); }),
        speed.is_last);
    const Peak q = peak(rows_, [this](const flight::Row& row) {
      return atmosphere_.density_kg_m3(height_m(row)) * speed_m_s(row) * speed_m_s(row);
    });
    if (!is_simulated_ && flight_.unmeasured.speed_bound_from_s) {
      add("max_q_s", {}, "an accelerometer was at the end of its range, so the speed is not known");
    } else {
      const Number range = at_or_in(q.time_s, missing_);
      add("max_q_s", Number{range.low, q.is_last ? infinity : range.high}, with_missing(estimated(), missing_));
    }
  }

  /// The rows reach the end of the ascent.
  [[nodiscard]] bool is_whole() const {
    if (is_log_) {
      return missing_.empty();
    }
    const auto end_s = end_of_ascent(flight_);
    return end_s && flight_.rows.back().time_s >= *end_s;
  }

  void add_control_start() {
    const auto& start_s = is_log_ ? control_.start_s : flight_.events.control_start_s;
    const auto row = std::ranges::find_if(rows_, [&](const flight::Row& r) { return start_s && r.time_s >= *start_s; });
    if (row == rows_.end()) {
      for (const char* name : {"control_start_s", "control_start_height_m"}) {
        add(name, {},
            !is_log_  ? "control never began"
            : start_s ? "control began after the ascent"
                      : control_.why_unknown);
      }
      return;
    }
    const double first_s = is_log_ ? control_.first_s.value_or(*start_s) : *start_s;
    const auto before = std::ranges::lower_bound(rows_, first_s, {}, &flight::Row::time_s);
    const Number first = height_range_m(*before);
    const Number last = height_range_m(*row);
    add("control_start_s", Number{first_s, *start_s}, first_s < *start_s ? "it may have begun in a hole before" : "");
    add("control_start_height_m", Number{std::min(first.low, last.low), std::max(first.high, last.high)},
        estimated_height(*row));
  }

  void add_canards() {
    if (!flight_.known.plan) {
      for (const char* name : {"left_trim", "left_trim_s", "left_trim_height_m", "canard_before_control_deg",
                               "tilt_off_trim_deg", "off_trim_after_abort"}) {
        add(name, {}, "the file has no flight plan, so the trims are not known");
      }
      return;
    }
    Departure found = departure(rows_, flight_.plan);
    if (!found.time_s && !found.hidden_from_s && !is_whole()) {
      found.hidden_from_s = rows_.back().time_s;
    }
    const std::optional<double>& hidden_s = found.hidden_from_s;
    add("left_trim",
        found.time_s ? std::optional<Known>{true}
        : hidden_s   ? std::nullopt
                     : std::optional<Known>{false},
        departure_text(found));
    if (!found.time_s) {
      const std::string why = hidden_s ? "not seen to the end" : "no canard left trim";
      add("left_trim_s", {}, why);
      add("left_trim_height_m", {}, why);
    } else {
      const Number earliest = height_range_m(hidden_s ? found.hidden_row : found.row);
      const Number seen = height_range_m(found.row);
      const std::vector<Hole> hidden = is_log_ ? holes(rows_, 0.0, *found.time_s) : std::vector<Hole>{};
      add("left_trim_s", Number{hidden_s.value_or(*found.time_s), *found.time_s}, missing_text(hidden));
      add("left_trim_height_m", Number{std::min(earliest.low, seen.low), std::max(earliest.high, seen.high)},
          estimated_height(found.row));
    }
    add_before_control();
    all_.merge(return_to_trim(flight_, rows_,
                              is_log_ || is_whole() ? missing_ : std::vector{Hole{rows_.back().time_s, infinity}}));
  }

  void add_before_control() {
    const auto before_s = is_log_ ? control_.before_s : flight_.events.control_start_s.value_or(infinity);
    if (!before_s) {
      add("canard_before_control_deg", {}, control_.why_unknown);
      return;
    }
    double largest_rad = 0.0;
    for (const flight::Row& row : rows_) {
      if (row.time_s < 0.0 || row.time_s >= *before_s) {
        continue;
      }
      for (std::size_t i = 0; i < core::canard_count; ++i) {
        const auto trim_rad = static_cast<double>(flight_.plan.canards.each[i].trim.radians());
        largest_rad = std::max(largest_rad, std::abs(canard_rad(row, i).value_or(trim_rad) - trim_rad));
      }
    }
    const std::vector<Hole> hidden = !is_log_               ? std::vector<Hole>{}
                                     : *before_s < infinity ? holes(flight_.rows, 0.0, *before_s)
                                                            : missing_;
    const bool is_seen =
        hidden.empty() && !silent_from_s(rows_, 0.0, *before_s) && (is_whole() || *before_s < infinity);
    const bool is_known = is_seen && (!is_log_ || control_.start_s || control_.never_began);
    add("canard_before_control_deg",
        Number{text::degrees(largest_rad), is_known ? text::degrees(largest_rad) : infinity}, missing_text(hidden));
  }

  const flight::Flight& flight_;
  const sim::Atmosphere& atmosphere_;
  bool is_log_;
  std::optional<double> motor_burns_s_;
  Rows rows_;
  bool is_simulated_;
  std::vector<Hole> missing_;  ///< of a log
  ControlInLog control_;       ///< likewise
  Findings all_;
};

Findings found_in(const flight::Flight& flight, const sim::Atmosphere& atmosphere, bool is_log,
                  const std::optional<double>& motor_burns_s) {
  const bool is_there = flight.events.liftoff_s || flight.events.detected_s;
  if (is_there && !ascent(flight).empty() && flight.differing_ticks == 0) {
    return OfFlight{flight, atmosphere, is_log, motor_burns_s}.take();
  }
  const bool begins_late = !flight.rows.empty() && flight.known.phase && core::is_flight(flight.rows.front().phase);
  const std::string why = flight.differing_ticks > 0 ? differing_text(flight)
                          : begins_late              ? "the record begins after the launch"
                                                     : "there is no launch in it";
  Findings all;
  for (const FigureText& figure : figure_texts()) {
    if (figure.name.starts_with("flight.")) {
      all[std::string{figure.name}] = {{}, why};
    }
  }
  return all;
}

}  // namespace

Findings of_flight(const flight::Flight& flight, const sim::Atmosphere& atmosphere) {
  return found_in(flight, atmosphere, false, {});
}

Findings of_log(const flight::Flight& log, const std::optional<double>& motor_burns_s) {
  return found_in(log, {}, true, motor_burns_s);
}

}  // namespace fantail::rules
