// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "flight/gate.hpp"
#include "flight/phase_names.hpp"
#include "report/verdict_parts.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

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

bool was_lost(const flight::Flight& flight) {
  if (flight.outages.empty() || flight.outages.back().resumed || flight.phase_changes.empty()) {
    return false;
  }
  return !flight.outages.back().to_s || flight.phase_changes.back().phase == core::Phase::safe;
}

bool was_under_control(std::span<const flight::PhaseChange> changes) {
  return std::ranges::find(changes, core::Phase::controlling, &flight::PhaseChange::phase) != changes.end();
}

bool ends_a_wait(const flight::Flight& flight) {
  return flight.events.dormant_s && !was_under_control(flight.phase_changes);
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
  if (by_tilt && !flight.seed) {
    return false;  // how soon before apogee it may be is a number of a scenario
  }
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
  const auto& end_s = flight.events.control_end_s;
  if (!flight.seed && end_s && flight.phase_changes.back().reason == core::PhaseReason::tilted_too_far) {
    return fmt::format(" The tilt limit ended control at {} s. A log does not tell whether that is too early.",
                       text::fixed(*end_s, 2));
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
