// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/core.h>

#include "flight/gate.hpp"
#include "flight/phase_names.hpp"
#include "report/verdict_parts.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

/// To a reset after which nothing was resumed, or to one or a standstill after which nothing is on record any more.
bool was_lost(const flight::Flight& flight) {
  if (flight.outages.empty() || flight.outages.back().resumed || flight.phase_changes.empty()) {
    return false;
  }
  return !flight.outages.back().to_s || flight.phase_changes.back().phase == core::Phase::safe;
}

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
    return fmt::format("apogee at {} m, the gate opens at {} m", text::fixed(*f.apogee_m, 0), text::brief(*gate_m, 1));
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

/// Of a flight that came no farther than this change.
std::string why_not_from(const flight::Flight& flight, const flight::PhaseChange& change) {
  const std::string when = at(change);
  if (!change.reason) {
    return "the log does not say why";
  }
  switch (*change.reason) {
    case core::PhaseReason::armed_by_switch_and_command:
      return flight.tunnel ? "the start command never came while the rocket was at rest" : "no launch was detected";
    case core::PhaseReason::rested: return "no launch was detected after the rocket had rested at " + when;
    case core::PhaseReason::moved_without_launch:
      // In flight that is what follows from a launch that was not detected; before it, what kept one from being.
      return change.time_s > 0.0
                 ? "no launch was detected in the first " + when + " of the flight"
                 : "no launch was detected: the rocket had moved and had to rest first, from " + when + " on";
    case core::PhaseReason::launch_detected:
      return "the run ended before the rocket cleared the guide; launch was detected at " + when;
    case core::PhaseReason::guide_not_cleared_in_time: return why_guide_not_cleared(flight, change);
    default: return fmt::format("{} (at {})", flight::display_name(*change.reason), when);
  }
}

/// What ended it, if the canards still waited for their gate.
std::string why_not_from_dormant(const flight::Flight& flight, const flight::PhaseChange& last) {
  const std::string waited = "while the canards waited for " + flight::gate_name(flight);
  return last.phase == core::Phase::dormant
             ? fmt::format("the record ends {}, from {} on", waited, at(last))
             : fmt::format("{} (at {}), {}", last.reason ? flight::display_name(*last.reason) : "control was over",
                           at(last), waited);
}

std::string why_no_control(const flight::Flight& flight) {
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
    return why_not_from_dormant(flight, last);
  }
  if (last.reason != core::PhaseReason::flew_without_launch) {
    return why_not_from(flight, last);
  }
  // That it flew ends what began before: what it was armed or had to rest for says why the launch was not detected.
  return fmt::format("{}; at {} the rocket reported that it had flown",
                     changes > 1 ? why_not_from(flight, flight.phase_changes[changes - 2]) : "no launch was detected",
                     at(last));
}

/// Control was over before whatever ended the flight: the gate had closed.
bool closed_for_good(const flight::Flight& flight) {
  const std::size_t changes = flight.phase_changes.size();
  return flight.events.control_start_s && changes > 1 &&
         (flight.phase_changes[changes - 1].phase == core::Phase::dormant ||
          flight.phase_changes[changes - 2].phase == core::Phase::dormant) &&
         flight.phase_changes[changes - 1].phase != core::Phase::controlling;
}

std::string plan_time(const flight::Flight& flight) {
  return flight.known.plan
             ? fmt::format(" of {} s", text::brief(static_cast<double>(core::seconds(flight.plan.run.control_time)), 2))
             : "";
}

std::string turned_after_end(const Figures& f) {
  return f.roll_after_end_rad ? fmt::format(" After that the rocket turned by up to {} deg until {}.",
                                            text::fixed(text::degrees(*f.roll_after_end_rad), 1),
                                            f.ended_before_apogee_s ? "apogee" : "the trajectory ends")
                              : "";
}

}  // namespace

bool gate_stayed_closed(const flight::Flight& flight) {
  return !flight.phase_changes.empty() && !flight.events.control_start_s &&
         flight.phase_changes.back().reason == core::PhaseReason::gate_never_opened;
}

std::string no_control(const flight::Flight& flight, const Figures& f) {
  if (gate_stayed_closed(flight)) {
    return fmt::format("Control never began: {}. The canards stayed at trim, as the plan demands.",
                       gate_never_opened(flight, f, flight.phase_changes.back()));
  }
  const bool is_table =
      flight.phase_changes.empty() ? !flight.seed && flight.why_not_armed.empty() : !flight.phase_changes.back().reason;
  return is_table && !flight.rows.empty() ? no_control_in_rows(flight)
                                          : fmt::format("No control: {}.", why_no_control(flight));
}

std::optional<double> begun_on_guide_s(const flight::Flight& flight) {
  const auto& [start_s, clear_s] = std::pair{flight.events.control_start_s, flight.events.guide_clear_s};
  const bool is_on_guide = !flight.tunnel && start_s && clear_s && *start_s < *clear_s;
  return is_on_guide ? std::optional{*clear_s - *start_s} : std::nullopt;
}

std::string begun_on_guide(const flight::Flight& flight) {
  const auto before_s = begun_on_guide_s(flight);
  return before_s ? fmt::format(
                        " Control began {} s before the rocket left the launch guide, where moving canards can jam "
                        "it: check guide.length_m in the plan.",
                        text::fixed(*before_s, 3))
                  : "";
}

bool nothing_controls_roll(const flight::Flight& flight) {
  return flight.known.plan && !flight::has_gains(flight.plan);
}

bool ended_early(const flight::Flight& flight, const Figures& f) {
  if (was_lost(flight)) {
    return f.ended_before_apogee_s.value_or(2.0 * near_apogee_s) > near_apogee_s;
  }
  if (flight.phase_changes.empty() ||
      (flight.phase_changes.back().phase != core::Phase::finished && !closed_for_good(flight))) {
    return false;
  }
  // The highest point of a rocket whose ascent failed is none at which the air hardly flows.
  const bool has_failed = ascent_failed(flight);
  const bool by_tilt = flight.phase_changes.back().reason == core::PhaseReason::tilted_too_far;
  const double allowed_s = by_tilt ? flight.tilt_end_before_apogee_s : near_apogee_s;
  const bool is_early = f.ended_before_apogee_s.value_or(0.0) > allowed_s;
  if (is_early || (f.ended_before_apogee_s && !has_failed)) {
    return is_early;
  }
  const auto reason = flight.phase_changes.back().reason;
  if (reason == core::PhaseReason::control_time_over) {
    return flight.trajectory_end_s && !flight.tunnel;  // elsewhere apogee may have been before it
  }
  return reason && reason != core::PhaseReason::apogee;
}

std::string late_end(const flight::Flight& flight, const Figures& f) {
  const double before_s = f.ended_before_apogee_s.value_or(0.0);
  if (before_s < -near_apogee_s) {
    return fmt::format(" Control went on for {} s after apogee.", text::fixed(-before_s, 2));
  }
  constexpr double seen_s = 0.005;  // less is 0.00 s
  if (before_s < seen_s || flight.phase_changes.empty()) {
    return {};
  }
  const std::string before = text::fixed(before_s, 2);
  const flight::PhaseChange& end = flight.phase_changes.back();
  if (closed_for_good(flight)) {
    return fmt::format(" Control ended {} s before apogee: {}.", before, flight::gate_has_closed(flight));
  }
  if (end.phase != core::Phase::finished || !end.reason || end.reason == core::PhaseReason::apogee) {
    return {};
  }
  switch (*end.reason) {
    case core::PhaseReason::tilted_too_far:
      return fmt::format(" The tilt limit ended control {} s before apogee.{}", before,
                         allowed_tilt_end_s(flight, f)
                             ? fmt::format(" verdict.tilt_end_before_apogee_s = {} allows that.{}",
                                           text::brief(flight.tilt_end_before_apogee_s, 2), turned_after_end(f))
                             : "");
    case core::PhaseReason::control_time_over:
      return fmt::format(" The plan's control time{} was over {} s before apogee.", plan_time(flight), before);
    default: return fmt::format(" Control ended {} s before apogee: {}.", before, flight::display_name(*end.reason));
  }
}

std::string early_end(const flight::Flight& flight, const Figures& f) {
  const flight::PhaseChange& end = flight.phase_changes.back();
  const double end_s = flight.events.control_end_s.value_or(end.time_s);
  std::string text = fmt::format("Control ended at {} s", text::fixed(end_s, 2));
  if (f.ended_before_apogee_s.value_or(0.0) > 0.0) {
    text += fmt::format(", {} s before apogee", text::fixed(*f.ended_before_apogee_s, 2));
  }
  if (was_lost(flight)) {
    text += flight.outages.back().cause.empty() ? ": the processor stopped then."
                                                : ": the processor was reset, and the flight was not resumed.";
  } else if (closed_for_good(flight)) {
    text += fmt::format(": {}, and the plan's gate did not open again.", flight::gate_has_closed(flight));
  } else if (!end.reason) {
    text += "; the log does not say why.";
  } else if (end.reason == core::PhaseReason::apogee) {
    text += ": the avionics detected apogee too early.";
  } else if (end.reason == core::PhaseReason::control_time_over) {
    text += fmt::format(": the plan's control time{} was over.", plan_time(flight));
  } else {
    const bool is_seen_later = end_s < end.time_s - 0.01;
    text += fmt::format(": {}{}.", flight::display_name(*end.reason),
                        is_seen_later ? fmt::format(", seen at {} s", text::fixed(end.time_s, 2)) : "");
  }
  return text + turned_after_end(f);
}

}  // namespace fantail::report
