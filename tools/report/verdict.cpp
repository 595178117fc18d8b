// SPDX-License-Identifier: MIT
#include "report/verdict.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "report/hold.hpp"
#include "report/verdict_parts.hpp"
#include "text/apart.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

// More than rounding makes of an angle.
constexpr double same_angle_rad = 1e-9;

std::string degrees_text(double radians) { return fmt::format("{} deg", text::fixed(text::degrees(radians), 1)); }
std::string signed_limit(double radians) {
  return fmt::format("{}{} deg", radians > 0.0 ? "+" : "", text::brief(text::degrees(radians), 1));
}

std::string sentence(std::string clause) {
  clause.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(clause.front())));
  return clause + ".";
}

std::string saturation(const Figures& f) {
  if (f.saturated_fraction && *f.control_time_s == 0.0) {
    const char* const no = *f.saturated_fraction > 0.0 ? "" : "not ";
    return fmt::format("at the only recorded tick under control, the canards were {}at their limit", no);
  }
  return f.saturated_fraction
             ? fmt::format("canards at their limit {} % of control time", text::fixed(100.0 * *f.saturated_fraction, 1))
             : "the log does not say when canards were at their limit";
}

std::string saturation_and_margin(const flight::Flight& flight, const Figures& f) {
  std::string text = saturation(f);
  if (f.authority_margin_rad) {
    text +=
        fmt::format("; the canards can give {} {} than the {} need", degrees_text(std::abs(*f.authority_margin_rad)),
                    *f.authority_margin_rad < 0.0 ? "less" : "more", flight.tunnel ? "fins and the swirl" : "fins");
  }
  return text;
}

std::string at_limit(const flight::Flight& flight, const Figures& f) {
  return fmt::format("canards commanded to their limit ({}) from {} s to the end of {}",
                     signed_limit(f.command_at_end_rad), text::fixed(*f.at_limit_since_s, 2),
                     ends_under_control(flight, f) ? "the record" : "control");
}

std::string why_not_judged(const flight::Flight& flight, const Figures& f) {
  if (!flight.known.plan) {
    return "the plan is unknown, and so is the angle where roll should settle";
  }
  if (f.in_still_air) {
    return "the air is still, so the canards cannot turn the rocket";
  }
  const core::ControllerPlan& controller = flight.plan.controller;
  if (controller.proportional_gain == 0.0F && controller.derivative_gain_s == 0.0F) {
    return "the plan's gains are zero, so nothing controls the roll";
  }
  if (controller.proportional_gain == 0.0F) {
    return "without a proportional gain, no angle is held";
  }
  if (const std::string_view misses = what_misses_control(flight, f); !misses.empty()) {
    return std::string{misses};
  }
  const std::string lacks = f.largest_disturbance_rad ? what_hold_lacks(f.hold) : "the fin offset";
  if (!f.hold.is_ever_known && !lacks.empty()) {
    return lacks + " is unknown, and so is the angle where roll should settle";
  }
  if (f.judged_time_s) {
    return fmt::format("it could be judged for only {} s of {} s under control, and {} s are required",
                       text::fixed(*f.judged_time_s, 2), text::fixed(*f.control_time_s, 2),
                       text::brief(least_judged_s, 1));
  }
  return *f.control_time_s < 2.0 ? fmt::format("control lasted only {} s", text::fixed(*f.control_time_s, 2))
                                 : "the reference was never constant for long enough";
}

/// Where a rocket hardly rolls at all, it stays near every angle; nothing held it there. Empty: the loop can settle.
std::string why_nothing_settles(const flight::Flight& flight, const Figures& f) {
  if (!flight.airframe) {
    return {};  // not simulated
  }
  if (flight.loop_margins.empty()) {
    return "the canards turn the rocket too little for the loop gain to reach one";
  }
  double fastest_rad_s = 0.0;
  for (const flight::LoopMargin& margin : flight.loop_margins) {
    if (!margin.crossover_rad_s) {
      return {};
    }
    fastest_rad_s = std::max(fastest_rad_s, *margin.crossover_rad_s);
  }
  return fastest_rad_s * *f.control_time_s >= 1.0
             ? ""
             : fmt::format(
                   "the canards turn the rocket so little that the loop would need {} s or more to settle, and "
                   "control lasted {} s",
                   text::fixed(1.0 / fastest_rad_s, 0), text::fixed(*f.control_time_s, 1));
}

/// "; judged for 1.2 s of 9.9 s under control" where that is less than half; else empty.
std::string how_long_judged(const Figures& f) {
  return *f.judged_time_s < 0.5 * *f.control_time_s
             ? fmt::format("; judged for {} s of {} s under control", text::fixed(*f.judged_time_s, 1),
                           text::fixed(*f.control_time_s, 1))
             : "";
}

/// Both halves of a roll that is held: how steadily, and how far from what was asked.
Verdict steady(const flight::Flight& flight, const Figures& f, const std::string& rest) {
  const double rest_rad = f.rest_error_rad.value_or(0.0);
  const bool is_off = rest_rad > flight.rest_limit_rad + same_angle_rad;
  const double off_deg = text::degrees(rest_rad);
  const std::string off =
      is_off ? text::apart(off_deg, text::degrees(flight.rest_limit_rad), 1) : text::fixed(off_deg, 1);
  const std::string asked =
      is_off ? fmt::format(" ({} deg is the limit)", text::brief(text::degrees(flight.rest_limit_rad), 1)) : "";
  return {is_off ? Outcome::off_command : Outcome::held,
          sentence(fmt::format(
              "steady, {} deg from the command{}: {}, roll stayed within {} of where this law settles{}; {}", off,
              asked, once_settled(flight, !f.reopenings.empty()), degrees_text(*f.largest_hold_error_rad),
              how_long_judged(f), rest))};
}

/// Where the canards do not do what the law commands, neither the offset nor the gains decide, and there is no angle at
/// which it settles.
Verdict uncontrollable(const flight::Flight& flight, const Figures& f) {
  const bool is_lost =
      (f.at_limit_since_s && f.offset_beyond_limit) || f.largest_hold_error_rad.value_or(0.0) > held_error_rad;
  const std::string cause =
      sentence(fmt::format("roll not {}: {}", is_lost ? "held" : "judged", flight.why_uncontrollable));
  const std::string mean = is_lost && f.mean_reference_error_rad
                               ? degrees_text(*f.mean_reference_error_rad) + " from the command in the mean; "
                               : "";
  const std::string at_end = f.at_limit_since_s ? fmt::format(" {}", sentence(at_limit(flight, f))) : "";
  return {is_lost ? Outcome::not_held : Outcome::not_judged,
          fmt::format("{} {}{}", cause, sentence(mean + saturation(f)), at_end)};
}

Verdict judge_control(const flight::Flight& flight, const Figures& f) {
  if (!flight.why_uncontrollable.empty() && !f.in_still_air && flight::has_gains(flight.plan)) {
    return uncontrollable(flight, f);
  }
  const std::string rest = saturation_and_margin(flight, f);
  if (f.at_limit_since_s && f.offset_beyond_limit) {
    const std::string off = not_following(flight);
    const std::string size = degrees_text(*f.offset_at_limit_rad);
    const std::string cause =
        fmt::format("{}: {}{} is beyond what they can balance; roll not held", at_limit(flight, f),
                    off.empty() ? "" : off + ", so ",
                    flight.tunnel ? "the sum of fin offset and swirl, " + size + "," : "the fin offset of " + size);
    return {Outcome::not_held, fmt::format("{} {}", sentence(cause), sentence(rest))};
  }
  const std::string ended_at_limit = f.at_limit_since_s ? fmt::format(" {}", sentence(at_limit(flight, f))) : "";
  if (f.largest_hold_error_rad) {
    const bool held = *f.largest_hold_error_rad <= held_error_rad;
    if (const std::string why = held ? why_nothing_settles(flight, f) : ""; !why.empty()) {
      return {Outcome::not_judged, sentence("roll not judged: " + why)};
    }
    if (const std::string_view misses = what_misses_control(flight, f); held && !misses.empty()) {
      const std::string on_record = fmt::format(
          "roll not judged: {}; where it is, the roll stayed within {} of where this law settles, {}; {}", misses,
          degrees_text(*f.largest_hold_error_rad), once_settled(flight, !f.reopenings.empty()), rest);
      return {Outcome::not_judged, sentence(on_record) + ended_at_limit};
    }
    if (held && *f.judged_time_s >= least_judged_s) {
      Verdict v = steady(flight, f, rest);
      v.text += ended_at_limit;
      return v;
    }
    if (!held) {
      const std::string mean = f.mean_reference_error_rad ? fmt::format("; in the mean {} from the command",
                                                                        degrees_text(*f.mean_reference_error_rad))
                                                          : "";
      return {Outcome::not_held, sentence(fmt::format("roll not held: {}, up to {} from where this law settles{}; {}",
                                                      once_settled(flight, !f.reopenings.empty()),
                                                      degrees_text(*f.largest_hold_error_rad), mean, rest)) +
                                     ended_at_limit};
    }
  }
  return {Outcome::not_judged, sentence(fmt::format("roll not judged: {}{}", why_not_judged(flight, f),
                                                    nothing_controls_roll(flight) ? "" : "; " + saturation(f))) +
                                   ended_at_limit};
}

void begin_lower(std::string& text) {
  text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
}

/// The verdict on the whole flight from the one on the time under control.
Verdict judge_flight(const flight::Flight& flight, const Figures& f) {
  Verdict v = judge_control(flight, f);
  v.roll_is_judged = v.outcome != Outcome::not_judged;
  if (f.oscillation) {
    const Oscillation& o = *f.oscillation;
    v.outcome = is_steady(v.outcome) ? Outcome::oscillates : v.outcome;
    v.text = fmt::format("The canards oscillate at {} Hz between {} and {} deg, from {} s on, without any excitation. ",
                         text::brief(o.frequency_hz, 2), text::fixed(text::degrees(o.lowest_rad), 1),
                         text::fixed(text::degrees(o.highest_rad), 1), text::fixed(o.from_s, 2)) +
             v.text;
  }
  const auto worst = std::ranges::min_element(flight.loop_margins, {}, &flight::LoopMargin::phase_margin_rad);
  if (worst != flight.loop_margins.end() && worst->phase_margin_rad <= 0.0) {
    v.outcome = is_steady(v.outcome) ? Outcome::oscillates : v.outcome;
    v.text = fmt::format("The loop is unstable: at {} m/s, its phase margin is {}. ", text::fixed(worst->speed_m_s, 0),
                         degrees_text(worst->phase_margin_rad)) +
             v.text;
  }
  if (const flight::Unmeasured& u = flight.unmeasured; u.spin_from_s) {
    v.outcome = Outcome::not_held;
    v.text =
        fmt::format("The rocket turned faster than the gyro's range of {} deg/s, {}, for {} s in all, first at {} s. ",
                    text::fixed(std::abs(text::degrees(u.spin_rad_s)), 0),
                    u.spin_rad_s > 0.0 ? "positively" : "negatively", text::fixed(u.spin_for_s, 2),
                    text::fixed(*u.spin_from_s, 2)) +
        v.text;
  }
  if (ended_early(flight, f)) {
    v.ended_early = true;
    v.ended_by_tilt = flight.phase_changes.back().reason == core::PhaseReason::tilted_too_far;
    const bool rolled_away = f.roll_after_end_rad.value_or(0.0) > held_error_rad;
    v.outcome = rolled_away || v.outcome == Outcome::not_held ? Outcome::not_held : Outcome::cut_short;
    begin_lower(v.text);
    v.text = fmt::format("{} Until then: {}", early_end(flight, f), v.text);
  } else {
    v.allowed_tilt_end_s = allowed_tilt_end_s(flight, f);
    v.text += late_end(flight, f);
  }
  return v;
}

/// A trajectory of another program that ends in the climb says nothing of the rest, and neither does a recording.
void say_how_far_it_reaches(Verdict& v, const std::string& end) {
  v.outcome = is_steady(v.outcome) ? Outcome::cut_short : v.outcome;
  begin_lower(v.text);
  v.text = fmt::format("Until {}: {}", end, v.text);
}

/// What a simulation does not hold for takes the green from a verdict, whatever it is, and stands before it.
void say_what_is_outside_the_model(Verdict& v, const flight::Flight& flight) {
  const std::string beyond = flight::how_far_beyond(flight.extremes);
  if (beyond.empty()) {
    return;
  }
  v.outcome = is_steady(v.outcome) ? Outcome::outside_model : v.outcome;
  v.text = flight::outside_model(beyond) + v.text;
}

Verdict on_roll(const flight::Flight& flight, const Figures& figures) {
  if (!flight.known.phase) {
    return {Outcome::not_judged, "Roll not judged: the log does not say when control was active."};
  }
  if (!figures.control_time_s && (flight.events.control_start_s || may_hide_control(flight, figures))) {
    return {Outcome::not_judged,
            fmt::format("Roll not judged: no tick under control is on record.{}", unknown_roll(flight, figures))};
  }
  Verdict v = figures.control_time_s ? judge_flight(flight, figures)
                                     : Verdict{.outcome = Outcome::no_control, .text = no_control(flight, figures)};
  v.as_planned = !figures.control_time_s && gate_stayed_closed(flight);
  v.begun_on_guide_s = begun_on_guide_s(flight);
  v.text += begun_on_guide(flight) + outages(flight) + unknown_roll(flight, figures) + unmeasured(flight) +
            canard_faults(flight);
  if (flight.trajectory_end_s) {
    say_how_far_it_reaches(
        v, fmt::format("the trajectory ends at {} s, before apogee", text::fixed(*flight.trajectory_end_s, 2)));
  } else if (ends_under_control(flight, figures) && !flight.events.control_end_s) {
    say_how_far_it_reaches(v,
                           fmt::format("the record ends at {} s, under control", text::fixed(figures.roll.end_s, 2)));
  }
  say_what_is_outside_the_model(v, flight);
  return v;
}

}  // namespace

Verdict verdict(const flight::Flight& flight, const Figures& figures) {
  Verdict v = on_roll(flight, figures);
  if (const std::string failed = failed_ascent(flight); !failed.empty()) {
    v.outcome = ascent_failed(flight) ? Outcome::ascent_failed : v.outcome;
    v.text = failed + " " + v.text;
  }
  return v;
}

}  // namespace fantail::report
