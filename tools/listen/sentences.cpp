// SPDX-License-Identifier: MIT
#include "listen/sentences.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/inputs.hpp"
#include "listen/pad.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::listen {
namespace {

// What the pad's average of the law is made of, with its guard (core/pad_window.hpp).
constexpr double law_pad_window_s = 3.5;

std::string in_ms(double time_s) { return text::brief(1e3 * time_s, 3); }

std::string rate_sentence(const Heard& heard) {
  constexpr double law_tick_s = 1e-3;
  const bool is_faster = heard.log.interval_s < law_tick_s * (1.0 - 1e-6);
  return fmt::format(
      "The log's usual interval {}is {} ms ({} samples a second). Values between two samples are interpolated "
      "linearly, and the law ran on them 1000 times a second. {}",
      heard.lift_off_s ? "around lift-off " : "", in_ms(heard.log.interval_s),
      text::brief(1.0 / heard.log.interval_s, 1),
      is_faster
          ? "The log is faster than that, and the law received only the interpolated value at each of its ticks. "
            "Nothing is averaged: short events between two ticks may be missed, and motion faster than 500 Hz looks "
            "slower."
          : "Motion faster than the log's rate is not included.");
}

// What a log of minutes under a parachute lacks behind apogee is nobody's concern.
struct EndOfInterest {
  double time_s = 0.0;
  const char* whose = "";
};

std::optional<EndOfInterest> end_of_interest(const Heard& heard) {
  const auto& law_s = heard.apogee_s;
  const auto& log_s = heard.log_height.apogee_s;
  if (law_s && log_s) {
    return EndOfInterest{std::max(*law_s, *log_s), "the later of the law's and the log's"};
  }
  return law_s   ? std::optional{EndOfInterest{*law_s, "the law's"}}
         : log_s ? std::optional{EndOfInterest{*log_s, "the log's"}}
                 : std::nullopt;
}

// All of them are counted, as in the JSON, and those of the flight apart.
std::string gap_sentence(const Heard& heard) {
  const auto end = end_of_interest(heard);
  std::vector<Gap> flown = heard.gaps;
  std::erase_if(flown, [&](const Gap& gap) { return end && gap.from_s >= end->time_s; });
  if (heard.gaps.empty()) {
    return {};
  }
  const std::string longer = fmt::format("longer than the {} ms that are interpolated", in_ms(heard.longest_bridge_s));
  const std::string all =
      heard.gaps.size() == 1 ? "One gap of the log is" : fmt::format("{} gaps of the log are", heard.gaps.size());
  if (flown.empty()) {
    return fmt::format("{} {}; none begins before apogee ({}).", all, longer, end->whose);
  }
  const auto longest = std::ranges::max_element(flown, {}, [](const Gap& gap) { return gap.to_s - gap.from_s; });
  return fmt::format(
      "{} {}{}. There the law received its old samples, which go stale after {} ms. The longest of these gaps is "
      "from {:.3f} s to {:.3f} s of the log's clock.",
      all, longer,
      flown.size() == heard.gaps.size()
          ? ""
          : fmt::format("; {} before apogee ({})",
                        flown.size() == 1 ? "1 begins" : fmt::format("{} begin", flown.size()), end->whose),
      in_ms(static_cast<double>(core::seconds(heard.flown.motion.stale_time))), longest->from_s, longest->to_s);
}

std::string second_sentence(const Heard& heard) {
  const bool two = heard.flown.launch_detection.accelerometers == core::AccelerometerRule::two_agree;
  if (heard.log.second_axial.is_there()) {
    return two ? "The plan asks for two accelerometers that agree, and the law received both of the log's. Lateral "
                 "readings are those of the first."
               : "The plan asks for one accelerometer. The log's second one replaces the first where that is at the "
                 "end of its range.";
  }
  return two ? "The plan asks for two accelerometers that agree, and the log has one. The law received its samples "
               "as both, so this run does not show how well two real ones agree."
             : "";
}

// A gyro whose zero is farther off than the plan's quiet rate turns for ever, as far as the law can tell.
std::string why_no_rest(const Heard& heard) {
  const double quiet_rad_s = static_cast<double>(heard.flown.motion.quiet_rate_rad_s);
  for (const auto& [what, signal] : {std::pair{"roll", &heard.log.roll_rate}, std::pair{"pitch", &heard.log.pitch_rate},
                                     std::pair{"yaw", &heard.log.yaw_rate}}) {
    if (const auto mean = pad_mean(heard, *signal); mean && std::abs(*mean) > quiet_rad_s) {
      return fmt::format(" On the pad the gyro reads {} deg/s in {}, more than the plan's quiet rate of {} deg/s.",
                         text::brief(text::degrees(*mean), 1), what, text::brief(text::degrees(quiet_rad_s), 2));
    }
  }
  return {};
}

std::string pad_sentence(const Heard& heard, const Question& question) {
  const bool has_mean = heard.lift_off_s && heard.log.begin_s() < *heard.lift_off_s - 0.1;
  std::string padded =
      question.pad_s > 0.0
          ? fmt::format("The rocket was assumed to stand still for {} s before the log begins, with {}.",
                        text::brief(question.pad_s, 3),
                        has_mean ? "its mean readings up to 0.1 s before lift-off" : "its first readings")
          : "";
  if (heard.longest_rest_s >= law_pad_window_s) {
    return padded;
  }
  return padded + (padded.empty() ? "" : " ") +
         fmt::format(
             "Before lift-off the law found the rocket at rest for {} s at most, less than the {} s that its average "
             "on the pad needs. It assumed an upright guide and a gyro without offset.",
             text::fixed(heard.longest_rest_s, 2), law_pad_window_s) +
         why_no_rest(heard);
}

std::string clipped_sentence(const Heard& heard, const Clipped& clipped) {
  const bool is_rate = clipped.what.ends_with("rate");
  const RangeEnd& end = clipped.end;
  const std::string sentence = fmt::format(
      "{} stands at {} {} in {}, for up to {} ms, the first at {:.3f} s of the log's clock, as at the end of its range",
      clipped.what, text::brief(is_rate ? text::degrees(end.value) : end.value, 2),
      is_rate ? "deg/s" : fmt::format("m/s2 ({} g)", text::brief(end.value / one_g_m_s2, 2)),
      text::counted(end.samples, "sample"), in_ms(end.longest_s), end.first_s);
  if (clipped.what == "axial" && end.value > 0.0) {
    return sentence + (heard.is_lower_bound ? fmt::format(". The law's speed and height are lower bounds{}.",
                                                          heard.apogee_s ? ", and its apogee comes too early" : "")
                                            : ".");
  }
  if (clipped.what == "axial") {
    return sentence +
           ". The rocket slowed down more than that, so the law's speed and height are too large from there on.";
  }
  return sentence + (is_rate ? ": angles that follow from it are too small." : ".");
}

std::string unbelievable_sentence(const Heard& heard) {
  const auto beyond = std::ranges::count_if(heard.log.axial.value, [](double value) {
    return std::abs(value) > static_cast<double>(core::largest_specific_force_m_s2);
  });
  return beyond == 0
             ? ""
             : fmt::format("{} samples of the axial force are beyond {} m/s2, which the law rejects from any sensor.",
                           beyond, core::largest_specific_force_m_s2);
}

}  // namespace

bool is_refused_for_disagreement(const Heard& heard) {
  const Finding found = finding(heard);
  const bool not_in_time = found == Finding::missed || found == Finding::imagined_and_missed || found == Finding::late;
  return (not_in_time && heard.no_hold.in_all_s > 0.0) || (!heard.control && heard.no_control.in_all_s > 0.0);
}

std::string disagreement_sentence(const Heard& heard) {
  const Disagreement& no_hold = heard.no_hold;
  const Disagreement& no_control = heard.no_control;
  if (no_hold.in_all_s <= 0.0 && no_control.in_all_s <= 0.0) {
    return {};
  }
  const core::LaunchDetectionPlan& rule = heard.flown.launch_detection;
  std::vector<std::string> refused;
  if (no_hold.in_all_s > 0.0) {
    const auto& gap = heard.lift_off_gap;
    const bool in_time = heard.detected_s && *heard.detected_s <= listened_until_s(heard);
    refused.push_back(fmt::format(
        "for {} ms {}{} (first at {:.3f} s of the log's clock), and each time the law restarted its hold time",
        in_ms(no_hold.in_all_s),
        in_time ? "between "
        : gap   ? "up to a second after "
                : "in the second after ",
        std::string{gap ? "the gap of lift-off" : "lift-off"} + (in_time ? " and the detection" : ""),
        no_hold.first_s));
  }
  if (no_control.in_all_s > 0.0) {
    refused.push_back(
        fmt::format("at most a quarter of a second before the law assumed the rocket to be beyond its guide. So "
                    "control did not begin for {} ms, from {:.3f} s on",
                    in_ms(no_control.in_all_s), no_control.first_s));
  }
  return fmt::format(
      "The two accelerometers differed by more than the plan's {} g{}: {}.",
      text::brief(static_cast<double>(rule.disagreement_m_s2) / one_g_m_s2, 2),
      rule.low_pass ? fmt::format(" after its low-pass of {} Hz", text::brief(static_cast<double>(rule.low_pass_hz), 1))
                    : "",
      fmt::join(refused, "; "));
}

std::vector<std::string> notes_of(const Heard& heard, const Question& question) {
  std::vector<std::string> notes{further_sentence(heard),
                                 rate_sentence(heard),
                                 gap_sentence(heard),
                                 second_sentence(heard),
                                 is_refused_for_disagreement(heard) ? "" : disagreement_sentence(heard),
                                 pad_sentence(heard, question)};
  for (const Clipped& clipped : heard.clipped) {
    notes.push_back(clipped_sentence(heard, clipped));
  }
  notes.push_back(unbelievable_sentence(heard));
  notes.insert(notes.end(), heard.log.notes.begin(), heard.log.notes.end());
  std::erase(notes, std::string{});
  return notes;
}

}  // namespace fantail::listen
