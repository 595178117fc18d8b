// SPDX-License-Identifier: MIT
#include <cmath>
#include <string_view>

#include <fmt/core.h>

#include "stability/margins_asked.hpp"
#include "stability/speed_range.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tune/results.hpp"

namespace fantail::tune {
namespace {

using text::brief;
using text::degrees;
using text::fixed;

std::string number(float value) { return brief(static_cast<double>(value), 4); }

std::string rockets(std::size_t number) { return text::counted(number, "rocket"); }

std::string settling(const std::optional<double>& settling_s) {
  return settling_s ? "settles in " + fixed(*settling_s, 2) + " s" : "does not settle in 10 s";
}

std::string loop(const Judged& judged) {
  return fmt::format("a least phase margin of {} degrees (at {} m/s) and {}",
                     fixed(degrees(judged.least.phase_margin_rad), 1), fixed(judged.least.speed_m_s, 0),
                     settling(judged.settling_s));
}

std::string error(const Sum& sum) {
  std::string text = fmt::format("{} degrees on average and {} at most", fixed(degrees(*sum.mean_rad), 2),
                                 fixed(degrees(*sum.largest_rad), 1));
  if (sum.not_judged == sum.flights) {
    return text;
  }
  text += fmt::format(" (held in {} of {}", sum.held, sum.flights);
  text += sum.off_command > 0 ? fmt::format(", {} steady off the command", sum.off_command) : "";
  text += sum.outside_model > 0 ? fmt::format(", {} steady outside the model", sum.outside_model) : "";
  return text + (sum.not_judged > 0 ? fmt::format(", {} not judged)", sum.not_judged) : ")");
}

std::string limit_sentence(const Tuning& t) {
  const double left_rad = t.reach_rad - std::abs(t.largest_offset_rad);
  if (left_rad <= 0.0 || left_rad > 0.3 * t.reach_rad) {
    return {};
  }
  return fmt::format(
      "The {} leaves {} degrees beside a fin offset of {} degrees. No gains turn the rocket faster than these degrees "
      "can.",
      t.limit, brief(degrees(left_rad), 1), brief(degrees(t.largest_offset_rad), 1));
}

std::string range_sentence(const Tuning& t) {
  const core::OffsetPlan& offset = t.after->plan.offset;
  const bool integral = offset.rejection == core::OffsetRejection::integral;
  const auto value = static_cast<double>(integral ? offset.integral_gain_per_s : offset.observer_bandwidth_rad_s);
  const double most =
      stability::plan_range("offset", integral ? "integral_gain_per_s" : "observer_bandwidth_rad_s").maximum;
  if (offset.rejection == core::OffsetRejection::none || value < 0.99 * most) {
    return {};
  }
  return fmt::format("The {} of {} is the largest that a plan allows, so it is the end of the search, not an optimum.",
                     integral ? "integral gain" : "observer's bandwidth", brief(value, 2));
}

std::string spread_sentence(const Tuning& t) {
  constexpr double of_a_shape = 2.0;
  return t.is_measured || t.request.spread >= of_a_shape
             ? ""
             : "The scenario names no tunnel_result. Damping and torque from a shape are right within a factor of two, "
               "which --spread 2 covers.";
}

std::string margin_sentence(const Tuning& t) {
  return t.after->least.phase_margin_rad < stability::least_phase_margin_rad
             ? fmt::format("That is little: a prediction requires {} degrees, over its own spread.",
                           brief(stability::least_phase_margin_deg, 1))
             : "";
}

}  // namespace

std::string law_words(const core::FlightPlan& plan) {
  std::string words =
      fmt::format("{} and {} s", number(plan.controller.proportional_gain), number(plan.controller.derivative_gain_s));
  if (plan.offset.rejection == core::OffsetRejection::integral) {
    words += ", integral gain " + number(plan.offset.integral_gain_per_s) + " 1/s";
  } else if (plan.offset.rejection == core::OffsetRejection::observer) {
    words += ", observer of " + number(plan.offset.observer_bandwidth_rad_s) + " rad/s";
  }
  if (plan.gain_schedule.speeds_count > 0) {
    words += fmt::format(", times {} at {} m/s to {} at {} m/s", number(plan.gain_schedule.factors.front()),
                         number(plan.gain_schedule.speeds_m_s.front()),
                         number(plan.gain_schedule.factors[plan.gain_schedule.factors_count - 1U]),
                         number(plan.gain_schedule.speeds_m_s[plan.gain_schedule.speeds_count - 1U]));
  }
  return words;
}

std::string loop_sentence(const Tuning& t) {
  return t.after ? fmt::format("Over the spread the linear loop has {}; with the old plan, {}.", loop(*t.after),
                               loop(t.before))
                 : fmt::format("Over the spread the linear loop of the plan has {}.", loop(t.before));
}

std::string model_sentence(const Tuning& t) {
  const std::string beyond = flight::how_far_beyond(t.extremes());
  return beyond.empty() ? "" : fmt::format("Outside the model: {}.", beyond);
}

namespace {

/// Of a plan that is not proposed: of flights that were steady, or else of held ones, it has fewer.
std::string lost(const Sum& before, const Sum& after) {
  return after.steady < before.steady
             ? fmt::format("The new plan keeps the roll steady in {} of {}, the old one in {}.", after.steady,
                           text::counted(after.flights, "flight"), before.steady)
             : fmt::format("The new plan holds the roll in {} of {}, the old one in {}.", after.held,
                           text::counted(after.flights, "flight"), before.held);
}

/// With a space behind it; empty: none is held for verdict.tilt_end_before_apogee_s alone.
std::string allowed_tilt_ends(const Sum& sum, std::string_view plan) {
  const std::string sentence = sum.tilt_ends.sentence(sum.held, "flight");
  return sentence.empty() ? "" : fmt::format("{}: {}. ", plan, sentence);
}

}  // namespace

std::string flights_sentence(const Tuning& t) {
  const Sum before = t.flown_before();
  const Sum after = t.flown_after();
  if (!before.mean_rad || !after.mean_rad) {
    return "Not every flight came under control, so the plans are not compared." +
           (t.is_proposed() ? std::string{} : fmt::format(" {}", lost(before, after)));
  }
  const bool settled = before.is_settled && after.is_settled;
  const bool is_still = t.before.plan.reference.kind == core::ReferenceKind::hold;
  const std::string what = !settled   ? "over all time under control, because not all flights settle for a second"
                           : is_still ? "without the first second of control"
                                      : "without the first second of control and of each step";
  std::string text = fmt::format(
      "{} of the spread flown with both plans, {}: with the new plan the roll is {} from "
      "its reference, with the old one {}. ",
      rockets(after.flights), what, error(after), error(before));
  text += allowed_tilt_ends(after, "New plan") + allowed_tilt_ends(before, "Old plan");
  if (!t.is_proposed()) {
    return text + lost(before, after);
  }
  const double ratio = *after.mean_rad / *before.mean_rad;
  if (ratio < 0.98) {
    return text + fmt::format("The new plan is better: {} of the old error.",
                              ratio < 0.1 ? "less than a tenth" : fmt::format("{} %", fixed(100.0 * ratio, 0)));
  }
  return text + fmt::format("The new plan has {} % of the old error{}.", fixed(100.0 * ratio, 0),
                            t.after->least.phase_margin_rad > t.before.least.phase_margin_rad
                                ? "; its advantage is the margin"
                                : "");
}

std::vector<std::string> remarks(const Tuning& t) {
  std::vector<std::string> all{t.bound_by,         spread_sentence(t),
                               margin_sentence(t), range_sentence(t),
                               limit_sentence(t),  t.request.schedule ? schedules_left_out(t.speeds.range) : ""};
  std::erase(all, "");
  return all;
}

std::string present_plan(const Tuning& t) {
  if (!t.is_old_enough()) {
    return {};
  }
  return fmt::format("The present plan holds the roll in all {} of the spread. {}Its linear loop has {}. ",
                     text::counted(t.old_alone->flights, "flight"), allowed_tilt_ends(*t.old_alone, "There"),
                     loop(t.before));
}

std::string next_step(const Tuning& t) {
  const bool offset_is_too_large = std::abs(t.largest_offset_rad) >= t.reach_rad;  // why_none says what to do
  if (t.is_proposed() || !t.alternative.empty() || offset_is_too_large) {
    return {};
  }
  const std::string keep = "Nothing that was tried flies better than the plan as it is. ";
  return keep + (t.request.spread > 1.0
                     ? "Next: measure damping and torque in a tunnel, put them into the vehicle file, and tune with a "
                       "smaller --spread."
                     : "Next: tune with a smaller --margin or a longer --settling.");
}

std::vector<std::string> basis(const Tuning& t) {
  const Request& r = t.request;
  const char* const fastest = r.rejection == core::OffsetRejection::integral   ? "largest integral gain"
                              : r.rejection == core::OffsetRejection::observer ? "largest product of kp and bandwidth"
                                                                               : "largest kp";
  const bool rejects = r.rejection != core::OffsetRejection::none;
  std::vector<std::string> all;
  all.push_back(fmt::format(
      "Speeds: {} to {} m/s, those under control, median {} m/s. Damping and torque: each anywhere within a factor of "
      "{} "
      "of the vehicle's. Servo lag {} ms, dead time {} ms.",
      fixed(t.speeds.range.lowest_m_s, 0), fixed(t.speeds.range.highest_m_s, 0), fixed(t.speeds.median_m_s, 0),
      brief(r.spread, 2), brief(1e3 * t.servo_lag_s, 1), brief(1e3 * t.delay_s, 1)));
  all.push_back(fmt::format(
      "Only laws with a phase margin of {} degrees and a gain margin of two at every speed count. From {} s after a "
      "step of the reference, they stay within a tenth of it, at the median speed and above.",
      brief(degrees(r.phase_margin_rad), 1), brief(r.settling_s, 2)));
  all.push_back(fmt::format(
      "Only round numbers were tried, 24 in a decade{}: 0.16, 0.18, 0.20. Between them, a law may be a little faster.",
      rejects ? " (12 for kp)" : ""));
  all.push_back(
      fmt::format("In each third of a decade of kp{}, the law with the {} was kept{}. The law that flew best of the "
                  "fastest of these, with six other rockets of the spread, was chosen.",
                  r.schedule ? " and for each schedule" : "", fastest,
                  r.schedule ? ", on average over the time under control" : ""));
  all.push_back(fmt::format(
      "Flights: {}, each with both plans and the same seed, with the fin offset and everything else of the scenario. "
      "Held means that the roll stays near the angle where the law settles, and this is at most {} degrees from the "
      "reference R. A law that rejects the offset settles at R, another one at R + u_d/kp.",
      rockets(r.flights), brief(degrees(t.rest_limit_rad), 1)));
  return all;
}

}  // namespace fantail::tune
