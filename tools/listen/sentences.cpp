// SPDX-License-Identifier: MIT
#include "listen/sentences.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/core.h>

#include "core/inputs.hpp"
#include "listen/lift_off.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::listen {
namespace {

// What the pad's average of the law is made of, with its guard (core/pad_window.hpp).
constexpr double law_pad_window_s = 3.5;

std::string in_ms(double time_s) { return text::brief(1e3 * time_s, 3); }

// The end of what matters: what a log of minutes under a parachute lacks is nobody's concern.
double end_of_interest_s(const Heard& heard) {
  return std::max(heard.apogee_s.value_or(heard.log.begin_s()),
                  heard.log_height.apogee_s.value_or(heard.log.begin_s()));
}

std::string rate_sentence(const Heard& heard) {
  return fmt::format(
      "The log's usual interval {}is {} ms ({} samples a second). Between two samples every value runs in a straight "
      "line, on which the law was flown 1000 times a second: faster motion than the log's is not in it.",
      heard.lift_off_s ? "around lift-off " : "", in_ms(heard.log.interval_s),
      text::brief(1.0 / heard.log.interval_s, 1));
}

std::string gap_sentence(const Heard& heard) {
  std::vector<Gap> before = heard.gaps;
  if (heard.apogee_s || heard.log_height.apogee_s) {
    std::erase_if(before, [&](const Gap& gap) { return gap.from_s > end_of_interest_s(heard); });
  }
  if (before.empty()) {
    return {};
  }
  const auto longest = std::ranges::max_element(before, {}, [](const Gap& gap) { return gap.to_s - gap.from_s; });
  return fmt::format(
      "{} longer than the {} ms that are bridged by a straight line: the law was given its old samples there, which "
      "are stale after {} ms. The longest is from {:.3f} s to {:.3f} s of the log's clock.",
      before.size() == 1 ? "One gap is" : fmt::format("{} gaps are", before.size()), in_ms(heard.longest_bridge_s),
      in_ms(static_cast<double>(core::seconds(heard.flown.motion.stale_time))), longest->from_s, longest->to_s);
}

std::string second_sentence(const Heard& heard) {
  const bool two = heard.flown.launch_detection.accelerometers == core::AccelerometerRule::two_agree;
  if (heard.log.second_axial.is_there()) {
    return two ? "Two accelerometers of the log were given to the law, which asks for two that agree; what they read "
                 "to "
                 "the sides was taken from the first."
               : "The plan asks for one accelerometer; the second of the log stands in where the first is at the end "
                 "of "
                 "its range.";
  }
  return two ? "The plan asks for two accelerometers that agree and the log has one: the law was given its samples as "
               "both, so nothing is said of how two real ones agree."
             : "";
}

// Mean before lift-off; of a log without one, of all of it.
std::optional<double> pad_mean(const Heard& heard, const Signal& signal) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < signal.time_s.size() && (!heard.lift_off_s || signal.time_s[i] < *heard.lift_off_s - 0.1);
       ++i) {
    sum += signal.value[i];
    count += 1.0;
  }
  return count > 0.0 ? std::optional{sum / count} : std::nullopt;
}

// Of what the axial force reads at rest: the guess that explains it.
std::string guess(double rest_g) {
  constexpr double about = 0.3;
  const auto is = [&](double g) { return std::abs(rest_g - g) < about; };
  return is(-1.0)  ? "its sign seems to be wrong (a minus before the column turns it around): "
         : is(0.0) ? "gravity seems not to be in it (axial_from_rest), or its unit is wrong: "
         : is(2.0) ? "gravity seems to be in it twice (axial instead of axial_from_rest): "
                   : "";
}

struct Rest {
  double mean_m_s2 = 0.0;
  std::string where{};
};

// What the axial force reads at rest: before lift-off; of a log that is not known to have any of that, at its
// beginning.
std::optional<Rest> at_rest(const Heard& heard) {
  if (const auto mean = heard.lift_off_s ? pad_mean(heard, heard.log.axial) : std::nullopt) {
    return Rest{*mean, "Before lift-off"};
  }
  constexpr double most_s = 1.0;
  constexpr double hold_s = 0.3;
  double until_s = heard.log.begin_s() + most_s;
  for (const Event& event : heard.events) {
    until_s = event.to == core::Phase::launched ? std::min(until_s, event.time_s - hold_s) : until_s;
  }
  const Signal& axial = heard.log.axial;
  const auto count = std::ranges::lower_bound(axial.time_s, until_s) - axial.time_s.begin();
  if (count == 0) {
    return std::nullopt;
  }
  const double sum = std::accumulate(axial.value.begin(), axial.value.begin() + count, 0.0);
  return Rest{sum / static_cast<double>(count),
              until_s < heard.log.begin_s() + most_s ? "Before the first detection" : "In its first second"};
}

// The sign, the unit and the axis of the one column that nothing can be heard without.
std::string axial_doubt(const Heard& heard) {
  constexpr double most_off_g = 0.3;
  const auto rest = at_rest(heard);
  if (!rest || std::abs(rest->mean_m_s2 / one_g_m_s2 - 1.0) <= most_off_g) {
    return {};
  }
  const double rest_g = rest->mean_m_s2 / one_g_m_s2;
  return fmt::format(
      "{} the axial force reads {} g in the mean, where a rocket in its guide reads 1 g: {}is it the right axis, sign "
      "and unit, and is gravity in it (axial) or not (axial_from_rest)?",
      rest->where, text::fixed(rest_g, 2), guess(rest_g));
}

std::string begin_doubt(const Heard& heard) {
  return heard.begins_at_lift_off()
             ? fmt::format(
                   "The log begins above {} g, so its first sample counts as lift-off: nothing before it is "
                   "known. Should it begin on the pad, the axial force is not what it was said to be.",
                   lift_off_g)
             : "";
}

std::string end_doubt(const Heard& heard) {
  const auto after_s = heard.since_lift_off_s(heard.log.end_s());
  return after_s && *after_s < late_s ? fmt::format(
                                            "The log ends {} s after lift-off: whether a flight followed is not "
                                            "in it.",
                                            text::fixed(*after_s, 2))
                                      : "";
}

std::string lift_off_gap_doubt(const Heard& heard) {
  if (heard.lift_off_gap) {
    return fmt::format(
        "Lift-off lies in a gap of the log, from {:.3f} s to {:.3f} s of its clock, in which the law was given nothing "
        "new: when it was, nobody knows.",
        heard.lift_off_gap->from_s, heard.lift_off_gap->to_s);
  }
  for (const Gap& gap : heard.gaps) {
    if (heard.lift_off_s && gap.to_s > *heard.lift_off_s && gap.from_s < *heard.lift_off_s + lift_off_window_s) {
      return fmt::format(
          "A gap of the log begins {:.2f} s after lift-off, and the rule of lift-off takes the force to run straight "
          "across it.",
          gap.from_s - *heard.lift_off_s);
    }
  }
  return {};
}

// The law hears until control ends, so that what it did may belong to a later push.
std::string other_flight_doubt(const Heard& heard) {
  const auto did_s = heard.control ? std::optional{heard.control->time_s} : heard.detected_s;
  return !heard.further_lift_offs_s.empty() && did_s >= heard.further_lift_offs_s.front()
             ? fmt::format(
                   "What the law heard comes after the push that begins at {} s of the log's clock: if that is another "
                   "launch, the figures are of that one, and the first was not followed.",
                   text::fixed(heard.further_lift_offs_s.front(), 2))
             : "";
}

// A barometer is slow, and Mach 1 and the wind disturb it; five seconds after a launch all that is small.
std::string height_doubt(const Heard& heard) {
  constexpr double after_s = 5.0;
  constexpr double enough_s = 3.0;
  constexpr double least_m = 10.0;
  const Signal& height = heard.log_height.above_pad;
  if (!heard.known_lift_off_s() || !height.is_there() || height.time_s.back() < *heard.lift_off_s + enough_s) {
    return {};
  }
  double rise_m = 0.0;
  for (std::size_t i = 0; i < height.time_s.size() && height.time_s[i] < *heard.lift_off_s + after_s; ++i) {
    if (height.time_s[i] > *heard.lift_off_s) {
      rise_m = std::max(rise_m, height.value[i]);
    }
  }
  return rise_m >= least_m ? ""
                           : fmt::format(
                                 "The log's own height rises by no more than {} m in the {} s after lift-off: was it a "
                                 "flight, and is the height what it was said to be?",
                                 text::fixed(rise_m, 1), after_s);
}

std::string interval_doubt(const Heard& heard) {
  constexpr double much_s = 0.25;
  return heard.log.interval_s > much_s
             ? "A quarter of a second and more between samples is much for a flight; is time in milliseconds?"
             : "";
}

// A gyro whose zero is farther off than the plan's quiet rate turns for ever, as far as the law can tell.
std::string why_no_rest(const Heard& heard) {
  const double quiet_rad_s = static_cast<double>(heard.flown.motion.quiet_rate_rad_s);
  for (const auto& [what, signal] : {std::pair{"roll", &heard.log.roll_rate}, std::pair{"pitch", &heard.log.pitch_rate},
                                     std::pair{"yaw", &heard.log.yaw_rate}}) {
    if (const auto mean = pad_mean(heard, *signal); mean && std::abs(*mean) > quiet_rad_s) {
      return fmt::format(" On the pad the gyro says {} deg/s of {}, beyond the plan's quiet rate of {} deg/s.",
                         text::brief(text::degrees(*mean), 1), what, text::brief(text::degrees(quiet_rad_s), 2));
    }
  }
  return {};
}

std::string pad_sentence(const Heard& heard, const Question& question) {
  const bool has_mean = heard.lift_off_s && heard.log.begin_s() < *heard.lift_off_s - 0.1;
  const std::string padded =
      question.pad_s > 0.0
          ? fmt::format("The rocket was taken to stand still for {} s before the log, at {}.",
                        text::brief(question.pad_s, 3),
                        has_mean ? "the mean of what it reads up to 0.1 s before lift-off" : "what it reads first")
          : "";
  if (heard.longest_rest_s >= law_pad_window_s) {
    return padded;
  }
  return padded + (padded.empty() ? "" : " ") +
         fmt::format(
             "The law saw the rocket at rest for {} s at the longest before lift-off, less than the {} "
             "s of its average on the pad: it took the guide as upright and the gyro as without offset.",
             text::fixed(heard.longest_rest_s, 2), law_pad_window_s) +
         why_no_rest(heard);
}

std::string clipped_sentence(const Heard& heard, const Clipped& clipped) {
  const bool is_rate = clipped.what.ends_with("rate");
  const RangeEnd& end = clipped.end;
  std::string sentence = fmt::format(
      "{} stands at {} {} in {} samples, for up to {} ms, the first at {:.3f} s of the log's clock: that looks like "
      "the end of its range",
      clipped.what, text::brief(is_rate ? text::degrees(end.value) : end.value, 2),
      is_rate ? "deg/s" : fmt::format("m/s2 ({} g)", text::brief(end.value / one_g_m_s2, 2)), end.samples,
      in_ms(end.longest_s), end.first_s);
  if (clipped.what == "axial" && end.value > 0.0) {
    return sentence + (heard.is_lower_bound ? fmt::format(". The law's speed and height are lower bounds{}.",
                                                          heard.apogee_s ? ", and its apogee comes too early" : "")
                                            : ".");
  }
  if (clipped.what == "axial") {
    return sentence +
           ". The rocket slowed down more than that, so that the law's speed and height are too large from "
           "there on.";
  }
  return sentence + (is_rate ? ": angles that follow from it are too small." : ".");
}

std::string unbelievable_sentence(const Heard& heard) {
  const auto beyond = std::ranges::count_if(heard.log.axial.value, [](double value) {
    return std::abs(value) > static_cast<double>(core::largest_specific_force_m_s2);
  });
  return beyond == 0 ? ""
                     : fmt::format(
                           "{} samples of the axial force are beyond {} m/s2, which the law does not believe of "
                           "any sensor.",
                           beyond, core::largest_specific_force_m_s2);
}

}  // namespace

std::vector<std::string> doubts_of(const Heard& heard) {
  std::vector<std::string> doubts{axial_doubt(heard),       begin_doubt(heard),  lift_off_gap_doubt(heard),
                                  interval_doubt(heard),    height_doubt(heard), end_doubt(heard),
                                  other_flight_doubt(heard)};
  std::erase(doubts, std::string{});
  return doubts;
}

std::vector<std::string> notes_of(const Heard& heard, const Question& question) {
  std::vector<std::string> notes{further_sentence(heard), rate_sentence(heard), gap_sentence(heard),
                                 second_sentence(heard), pad_sentence(heard, question)};
  for (const Clipped& clipped : heard.clipped) {
    notes.push_back(clipped_sentence(heard, clipped));
  }
  notes.push_back(unbelievable_sentence(heard));
  notes.insert(notes.end(), heard.log.notes.begin(), heard.log.notes.end());
  std::erase(notes, std::string{});
  return notes;
}

}  // namespace fantail::listen
