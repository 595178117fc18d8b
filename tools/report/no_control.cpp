// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/core.h>

#include "flight/gate.hpp"
#include "flight/phase_names.hpp"
#include "report/verdict_parts.hpp"
#include "text/apart.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

/// Rows without reasons may end before control or begin after it.
std::string no_control_in_rows(const flight::Flight& flight) {
  const flight::Row& last = flight.rows.back();
  const bool is_one = std::ranges::all_of(flight.rows, [&](const auto& row) { return row.phase == last.phase; });
  return fmt::format("No control in the log: in {} row the phase is {}.", is_one ? "every" : "its last",
                     flight::display_name(last.phase));
}

std::string at(const flight::PhaseChange& change) { return text::fixed(change.time_s, 2) + " s"; }

/// The largest that the avionics had between launch detection and this change; not a number where a row lacks it.
double largest(const flight::Flight& flight, const flight::PhaseChange& until, double flight::Row::* member) {
  double from_s = flight.rows.empty() ? 0.0 : flight.rows.front().time_s;
  for (const flight::PhaseChange& change : flight.phase_changes) {
    from_s = change.phase == core::Phase::launched && change.time_s < until.time_s ? change.time_s : from_s;
  }
  double found = std::numeric_limits<double>::quiet_NaN();
  for (const flight::Row& row : flight.rows) {
    if (row.time_s < from_s || row.time_s > until.time_s) {
      continue;
    }
    if (!std::isfinite(row.*member)) {
      return row.*member;
    }
    found = std::fmax(found, row.*member);
  }
  return found;
}

/// Control needs a distance, a speed and accelerometers that agree. Which of them was missing is said where it is
/// known.
std::string why_guide_not_cleared(const flight::Flight& flight, const flight::PhaseChange& change) {
  constexpr double steepest_guide = std::numbers::sqrt2;  // its length over its height: the avionics arm up to 45 deg
  const core::GuidePlan& guide = flight.plan.guide;
  const std::string within = fmt::format(
      "within {} s (at {})", text::brief(static_cast<double>(core::seconds(guide.clearance_time)), 2), at(change));
  const auto needed_m = static_cast<double>(guide.length_m + guide.clearance_m);
  const auto needed_m_s = static_cast<double>(guide.minimum_speed_m_s);
  const double height_m = largest(flight, change, &flight::Row::height_m);
  const double speed_m_s = largest(flight, change, &flight::Row::speed_m_s);
  const bool has_left = flight.events.guide_clear_s && *flight.events.guide_clear_s < change.time_s;
  if (flight.known.plan && steepest_guide * height_m < needed_m) {
    return has_left ? fmt::format(
                          "launch was detected, but {} the measured height, at most {} m, did not reach the "
                          "plan's guide.length_m and guide.clearance_m, together {} m",
                          within, text::fixed(height_m, 1), text::brief(needed_m, 2))
                    : "launch was detected, but the rocket did not clear the guide " + within;
  }
  if (flight.known.plan && speed_m_s <= needed_m_s) {
    return fmt::format(
        "launch was detected, but {} the measured speed, at most {} m/s, did not exceed the plan's "
        "guide.minimum_speed_m_s of {}",
        within, text::fixed(speed_m_s, 1), text::brief(needed_m_s, 2));
  }
  return "launch was detected, but the conditions for control were not all met at once " + within;
}

/// Of a flight whose gate did not open: the height that it would have needed, where that is why.
std::string gate_never_opened(const flight::Flight& flight, const Figures& f, const flight::PhaseChange& change) {
  const auto gate_m = flight::gate_height_m(flight);
  if (gate_m && f.apogee_m && *f.apogee_m <= *gate_m) {
    return fmt::format("apogee at {} m, the gate opens at {} m", text::apart(*f.apogee_m, *gate_m, 0),
                       text::brief(*gate_m, 1));
  }
  if (const double seen_m = largest(flight, change, &flight::Row::height_m);
      gate_m && !f.apogee_m && seen_m <= *gate_m) {
    return fmt::format("the measured height reached {} m, the gate opens at {} m", text::fixed(seen_m, 0),
                       text::brief(*gate_m, 1));
  }
  const bool needs_rate = flight.plan.dormancy.until != core::DormantUntil::burn_out;
  const std::string low_end = needs_rate && flight.unmeasured.spin_for_s > 0.0
                                  ? "; the gyro was at the end of its range, so height and speed were not known"
                              : gate_m ? "; it counts the low end of the height's error"
                                       : "";
  return fmt::format("the plan waits for {}, and that did not come before {} s{}", flight::gate_name(flight),
                     text::fixed(change.time_s, 2), low_end);
}

/// A record tells of no launch only as far as it goes; of a simulated flight nothing is missing.
std::string no_launch(const flight::Flight& flight) {
  return flight.seed || flight.rows.empty() ? "no launch was detected"
                                            : fmt::format("no launch was detected up to {} s, where the record ends",
                                                          text::fixed(flight.rows.back().time_s, 2));
}

/// Of a flight that came no farther than this change.
std::string why_not_from(const flight::Flight& flight, const flight::PhaseChange& change) {
  const std::string when = at(change);
  if (!change.reason) {
    return "the log does not say why";
  }
  switch (*change.reason) {
    case core::PhaseReason::armed_by_switch_and_command:
      return flight.tunnel ? "the start command never came while the rocket was at rest" : no_launch(flight);
    case core::PhaseReason::rested: return no_launch(flight) + "; the rocket had rested at " + when;
    case core::PhaseReason::moved_without_launch:
      // In flight that is what follows from a launch that was not detected; before it, what kept one from being.
      return flight.seed && change.time_s > 0.0
                 ? "no launch was detected in the first " + when + " of the flight"
                 : no_launch(flight) + ": the rocket had moved and had to rest first, from " + when + " on";
    case core::PhaseReason::launch_detected:
      return "the record ends before the rocket cleared the guide; launch was detected at " + when;
    case core::PhaseReason::guide_not_cleared_in_time: return why_guide_not_cleared(flight, change);
    default: return fmt::format("{} (at {})", flight::display_name(*change.reason), when);
  }
}

/// What ended it, if the canards still waited for their gate.
std::string why_not_from_dormant(const flight::Flight& flight, const Figures& f, const flight::PhaseChange& last) {
  const auto gate_m = flight::gate_height_m(flight);
  const std::string waited =
      fmt::format("while the canards waited for {}{}", flight::gate_name(flight),
                  gate_m && f.apogee_m && *f.apogee_m <= *gate_m
                      ? fmt::format(", above the apogee of {} m", text::apart(*f.apogee_m, *gate_m, 0))
                      : "");
  return last.phase == core::Phase::dormant
             ? fmt::format("the record ends {}, from {} on", waited, at(last))
             : fmt::format("{} (at {}), {}", last.reason ? flight::display_name(*last.reason) : "control was over",
                           at(last), waited);
}

std::string why_no_control(const flight::Flight& flight, const Figures& f) {
  if (flight.phase_changes.empty()) {
    return "the rocket was never armed" + (flight.why_not_armed.empty() ? "" : ", because " + flight.why_not_armed);
  }
  const flight::PhaseChange& last = flight.phase_changes.back();
  if (was_lost(flight)) {
    return flight.outages.back().cause.empty()
               ? fmt::format("the processor stopped at {} s", text::fixed(flight.outages.back().from_s, 2))
               : fmt::format("the processor was reset before it, and the flight was not resumed (at {})", at(last));
  }
  const std::size_t changes = flight.phase_changes.size();
  const bool was_dormant = changes > 1 && flight.phase_changes[changes - 2].phase == core::Phase::dormant;
  if (last.phase == core::Phase::dormant || (last.phase == core::Phase::finished && was_dormant)) {
    return why_not_from_dormant(flight, f, last);
  }
  if (last.reason != core::PhaseReason::flew_without_launch) {
    return why_not_from(flight, last);
  }
  // That it flew ends what began before: what it was armed or had to rest for says why the launch was not detected.
  return fmt::format("{}; at {} the rocket reported that it had flown",
                     changes > 1 ? why_not_from(flight, flight.phase_changes[changes - 2]) : "no launch was detected",
                     at(last));
}

}  // namespace

bool gate_stayed_closed(const flight::Flight& flight) {
  return !flight.phase_changes.empty() && !flight.events.control_start_s &&
         flight.phase_changes.back().reason == core::PhaseReason::gate_never_opened;
}

std::string no_control(const flight::Flight& flight, const Figures& f) {
  if (gate_stayed_closed(flight)) {
    return fmt::format("Control never began: {}. The canards were commanded to trim, as the plan demands.",
                       gate_never_opened(flight, f, flight.phase_changes.back()));
  }
  const bool is_table =
      flight.phase_changes.empty() ? !flight.seed && flight.why_not_armed.empty() : !flight.phase_changes.back().reason;
  return is_table && !flight.rows.empty() ? no_control_in_rows(flight)
                                          : fmt::format("No control: {}.", why_no_control(flight, f));
}

}  // namespace fantail::report
