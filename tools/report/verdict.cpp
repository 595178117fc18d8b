// SPDX-License-Identifier: MIT
#include "report/verdict.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "flight/phase_names.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

// Further from its settle point than this, a roll angle is not what anybody would call held.
constexpr double held_error_rad = text::radians(10.0);

std::string degrees_text(double radians) { return fmt::format("{} deg", text::fixed(text::degrees(radians), 1)); }
std::string signed_limit(double radians) {
  return fmt::format("{}{} deg", radians > 0.0 ? "+" : "", text::brief(text::degrees(radians), 1));
}

std::string sentence(std::string clause) {
  if (clause.front() >= 'a' && clause.front() <= 'z') {
    clause.front() = static_cast<char>(clause.front() - 'a' + 'A');
  }
  return clause + ".";
}

std::string why_no_control(const flight::Flight& flight) {
  if (flight.phase_changes.empty()) {
    return "the rocket was never armed";
  }
  const flight::PhaseChange& last = flight.phase_changes.back();
  if (!last.reason) {
    return "the log does not say why";
  }
  const std::string when = text::fixed(last.time_s, 2) + " s";
  switch (*last.reason) {
    case core::PhaseReason::armed_by_switch_and_command:
      return flight.tunnel ? "the start command never came at rest" : "no launch was detected";
    case core::PhaseReason::launch_detected:
      return "the run ended before the guide was clear; launch was detected at " + when;
    case core::PhaseReason::guide_not_cleared_in_time:
      return fmt::format("what looked like a launch did not clear the guide within {} s (at {})",
                         text::brief(static_cast<double>(core::seconds(flight.plan.guide.clearance_time)), 2), when);
    default: return fmt::format("{} (at {})", flight::display_name(*last.reason), when);
  }
}

std::string saturation_and_margin(const Figures& f) {
  std::string text = f.saturated_fraction
                         ? fmt::format("saturated {} % of control time", text::fixed(100.0 * *f.saturated_fraction, 0))
                         : "saturation is not in the log";
  if (f.authority_margin_rad) {
    text += "; authority margin " + degrees_text(*f.authority_margin_rad);
  }
  return text;
}

std::string at_limit(const Figures& f) {
  return fmt::format("canards at their limit ({}) from {} s to the end of control", signed_limit(f.command_at_end_rad),
                     text::fixed(*f.at_limit_since_s, 2));
}

std::string why_not_judged(const flight::Flight& flight, const Figures& f) {
  if (!flight.known.plan) {
    return "the plan, and with it where roll should settle, is unknown";
  }
  const core::ControllerPlan& controller = flight.plan.controller;
  if (controller.proportional_gain == 0.0F && controller.derivative_gain_s == 0.0F) {
    return "the plan's gains are zero, so the roll is free";
  }
  if (!f.largest_disturbance_rad || controller.proportional_gain == 0.0F) {
    return "the fin offset, and with it where roll should settle, is unknown";
  }
  return *f.control_time_s < 2.0 ? fmt::format("control lasted only {} s", text::fixed(*f.control_time_s, 2))
                                 : "the reference was never constant for long enough";
}

Verdict judge_control(const flight::Flight& flight, const Figures& f) {
  const std::string rest = saturation_and_margin(f);
  if (f.at_limit_since_s && f.offset_beyond_limit) {
    const std::string cause = fmt::format("{}: the fin offset of {} is more than they can balance; roll not held",
                                          at_limit(f), degrees_text(*f.offset_at_limit_rad));
    return {Outcome::not_held, fmt::format("{} {}", sentence(cause), sentence(rest))};
  }
  const std::string ended_at_limit = f.at_limit_since_s ? fmt::format(" {}", sentence(at_limit(f))) : "";
  if (f.largest_hold_error_rad) {
    const bool held = *f.largest_hold_error_rad <= held_error_rad;
    const std::string hold = fmt::format(fmt::runtime(held ? "roll stayed within {} of where this law settles; {}"
                                                           : "roll not held: up to {} from where this law settles; {}"),
                                         degrees_text(*f.largest_hold_error_rad), rest);
    return {held ? Outcome::held : Outcome::not_held, sentence(hold) + ended_at_limit};
  }
  return {Outcome::not_judged,
          sentence(fmt::format("roll not judged: {}; {}", why_not_judged(flight, f), rest)) + ended_at_limit};
}

std::string early_end(const flight::Flight& flight) {
  if (flight.phase_changes.empty() || flight.phase_changes.back().phase != core::Phase::finished) {
    return {};
  }
  const flight::PhaseChange& end = flight.phase_changes.back();
  if (!end.reason) {
    return {};
  }
  if (end.reason == core::PhaseReason::apogee || end.reason == core::PhaseReason::control_time_over) {
    return {};
  }
  return fmt::format(" Control ended at {} s: {}.", text::fixed(end.time_s, 2), flight::display_name(*end.reason));
}

std::string canard_faults(const flight::Flight& flight) {
  std::string text;
  std::array<bool, core::canard_count> named{};
  for (const flight::CanardVerdictChange& change : flight.canard_verdict_changes) {
    if (change.verdict != core::CanardVerdict::healthy && !named[change.canard]) {
      named[change.canard] = true;
      text += fmt::format(" Canard {} {} from {} s.", change.canard + 1, core::name(change.verdict),
                          text::fixed(change.time_s, 2));
    }
  }
  return text;
}

}  // namespace

Verdict verdict(const flight::Flight& flight, const Figures& figures) {
  if (!flight.known.phase) {
    return {Outcome::not_judged, "Roll not judged: the log does not say when control was active."};
  }
  Verdict v = figures.control_time_s
                  ? judge_control(flight, figures)
                  : Verdict{Outcome::no_control, fmt::format("No control: {}.", why_no_control(flight))};
  v.text += early_end(flight) + canard_faults(flight);
  return v;
}

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::held: return "held";
    case Outcome::not_held: return "not_held";
    case Outcome::not_judged: return "not_judged";
    case Outcome::no_control: return "no_control";
  }
  return "unknown";
}

std::string_view display_name(Outcome outcome) {
  switch (outcome) {
    case Outcome::held: return "Held";
    case Outcome::not_held: return "Not held";
    case Outcome::not_judged: return "Not judged";
    case Outcome::no_control: return "No control";
  }
  return "Unknown";
}

}  // namespace fantail::report
