// SPDX-License-Identifier: MIT
// Why the finding may be wrong.
#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "listen/lift_off.hpp"
#include "listen/pad.hpp"
#include "listen/sentences.hpp"
#include "text/number.hpp"

namespace fantail::listen {
namespace {

// Of what an axial force reads at rest: the guess that explains it.
std::string guess(double rest_g, const char* quantity) {
  constexpr double about = 0.3;
  const auto is = [&](double g) { return std::abs(rest_g - g) < about; };
  return is(-1.0)  ? "Its sign seems to be wrong (a minus before the column reverses it). "
         : is(0.0) ? fmt::format("It seems to lack gravity ({}_from_rest), or its unit is wrong. ", quantity)
         : is(2.0) ? fmt::format("It seems to include gravity twice ({0} instead of {0}_from_rest). ", quantity)
                   : "";
}

/// A force of 1 g along another axis, while the axial one is off.
bool sits_another_way(const Heard& heard, double axial_m_s2) {
  constexpr double about = 0.1;
  const auto y = at_rest(heard, heard.log.lateral_y);
  const auto z = at_rest(heard, heard.log.lateral_z);
  return y && z && std::abs(std::hypot(axial_m_s2, y->mean_m_s2, z->mean_m_s2) / one_g_m_s2 - 1.0) < about;
}

// The sign, the unit and the axis of the columns that nothing can be heard without.
std::string axial_doubt(const Heard& heard, const Signal& axial, const char* what, const char* quantity) {
  constexpr double most_off_g = 0.3;
  const auto rest = at_rest(heard, axial);
  if (!rest || std::abs(rest->mean_m_s2 / one_g_m_s2 - 1.0) <= most_off_g) {
    return {};
  }
  const double rest_g = rest->mean_m_s2 / one_g_m_s2;
  if (&axial == &heard.log.axial && sits_another_way(heard, rest->mean_m_s2)) {
    return fmt::format(
        "{} {} reads {} g on average, and the whole force 1 g. The x axis of the logger does not point to the nose "
        "(--mounting pad turns it there).",
        rest->where, what, text::fixed(rest_g, 2));
  }
  return fmt::format(
      "{} {} reads {} g on average, and a rocket in its guide reads 1 g. {}Check axis, sign and unit, and whether it "
      "includes gravity ({}) or not ({}_from_rest).",
      rest->where, what, text::fixed(rest_g, 2), guess(rest_g, quantity), quantity, quantity);
}

// What the law refused because of it.
std::string disagreement_doubt(const Heard& heard) {
  return is_refused_for_disagreement(heard) ? disagreement_sentence(heard) + " Check the columns of both." : "";
}

std::string begin_doubt(const Heard& heard) {
  return heard.begins_at_lift_off()
             ? fmt::format(
                   "The log begins above {} g, so its first sample counts as lift-off: nothing before it is known. "
                   "If the log begins on the pad, check the column of the axial force.",
                   lift_off_g)
             : "";
}

std::string end_doubt(const Heard& heard) {
  const auto after_s = heard.since_lift_off_s(heard.log.end_s());
  return after_s && *after_s < late_s ? fmt::format(
                                            "The log ends {} s after lift-off, so it does not show whether a flight "
                                            "followed.",
                                            text::fixed(*after_s, 2))
                                      : "";
}

std::string lift_off_gap_doubt(const Heard& heard) {
  if (heard.lift_off_gap) {
    return fmt::format(
        "Lift-off lies in a gap of the log, from {:.3f} s to {:.3f} s of its clock. Its time is unknown, and the law "
        "received nothing new there.",
        heard.lift_off_gap->from_s, heard.lift_off_gap->to_s);
  }
  for (const Gap& gap : heard.gaps) {
    if (heard.lift_off_s && gap.to_s > *heard.lift_off_s && gap.from_s < *heard.lift_off_s + lift_off_window_s) {
      return fmt::format(
          "A gap of the log begins {:.2f} s after lift-off, and the rule of lift-off interpolates the force across "
          "it.",
          gap.from_s - *heard.lift_off_s);
    }
  }
  return {};
}

// Of a gyro that is silent the law says that it has failed; here it is the log that says nothing.
std::string silence_doubt(const Heard& heard) {
  for (const Event& event : heard.events) {
    const bool is_silence =
        event.reason == core::PhaseReason::gyro_failed || event.reason == core::PhaseReason::gyro_failed_before_control;
    for (const Gap& gap : heard.gaps) {
      if (is_silence && gap.from_s < event.time_s && event.time_s <= gap.to_s + 0.1) {
        return fmt::format(
            "At {:.3f} s of the log's clock the law judged its gyro as failed, because the log has a gap there, from "
            "{:.3f} s to {:.3f} s. Its behaviour without the gap is unknown.",
            event.time_s, gap.from_s, gap.to_s);
      }
    }
    if (is_silence) {
      return fmt::format(
          "At {:.3f} s of the log's clock the law judged its gyro as failed, because the log has no usable rate "
          "there. Its behaviour with one is unknown.",
          event.time_s);
    }
  }
  return {};
}

// The law hears until control ends, so that what it did may belong to a later push.
std::string other_flight_doubt(const Heard& heard) {
  const auto did_s = heard.control ? std::optional{heard.control->time_s} : heard.detected_s;
  return !heard.further_lift_offs_s.empty() && did_s >= heard.further_lift_offs_s.front()
             ? fmt::format(
                   "The law reacted after the push that begins at {} s of the log's clock. If that is another "
                   "launch, the figures belong to it, and the first flight was not followed.",
                   text::fixed(heard.further_lift_offs_s.front(), 2))
             : "";
}

// A pad is 1 g. What pushes for long before it, or falls, is a flight that the rule of lift-off did not see.
std::string pad_doubt(const Heard& heard) {
  constexpr double least_g = 0.5;
  constexpr double most_g = 1.5;
  constexpr double longest_s = 0.5;
  const Signal& axial = heard.log.axial;
  double from_s = 0.0;
  double off_s = 0.0;
  for (std::size_t i = 1; heard.lift_off_s && i < axial.time_s.size() && axial.time_s[i] < *heard.lift_off_s - 0.1;
       ++i) {
    const double g = axial.value[i] / one_g_m_s2;
    off_s = g > least_g && g < most_g ? 0.0 : off_s + axial.time_s[i] - axial.time_s[i - 1];
    from_s = off_s > 0.0 ? from_s : axial.time_s[i];
    if (off_s > longest_s) {
      return fmt::format(
          "From {:.2f} s of the log's clock on, before lift-off, the axial force is outside {} to {} g for more than "
          "{} s. This may be a launch too weak for the rule of lift-off, and the later push the shock of its "
          "parachute.",
          from_s, least_g, most_g, longest_s);
    }
  }
  return {};
}

// Without a lift-off the height is asked: it must not have flown.
std::string flown_doubt(const Heard& heard) {
  constexpr double least_m = 20.0;
  const Signal& height = heard.log.height;
  if (heard.lift_off_s || !height.is_there()) {
    return {};
  }
  double lowest_m = height.value.front();
  double rise_m = 0.0;
  for (const double value : height.value) {
    lowest_m = std::min(lowest_m, value);
    rise_m = std::max(rise_m, value - lowest_m);
  }
  return rise_m < least_m ? ""
                          : fmt::format(
                                "The log's own height rises by {} m. Either a launch was too weak for the rule of "
                                "lift-off, or the column of the axial force is wrong.",
                                text::fixed(rise_m, 0));
}

// A barometer is slow, and Mach 1 and the wind disturb it; five seconds after a launch all that is small.
std::string height_doubt(const Heard& heard) {
  constexpr double after_s = height_within_s;
  constexpr double enough_s = 3.0;
  constexpr double least_m = 10.0;
  const Signal& height = heard.log_height.above_pad;
  if (!heard.known_lift_off_s() || !height.is_there()) {
    return {};
  }
  const auto is_early = [&](double time_s) {
    return time_s > *heard.lift_off_s && time_s < *heard.lift_off_s + after_s;
  };
  if (std::ranges::none_of(height.time_s, is_early) && heard.log.end_s() >= *heard.lift_off_s + enough_s) {
    return fmt::format(
        "The log's own height has no sample in the {} s after lift-off and is left out: check its clock and its unit "
        "of time.",
        after_s);
  }
  if (height.time_s.back() < *heard.lift_off_s + enough_s) {
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
                                 "The log's own height rises by no more than {} m in the {} s after lift-off. Check "
                                 "that this was a flight, and the column of the height.",
                                 text::fixed(rise_m, 1), after_s);
}

// Tilt that nobody measured and a parachute that opens early make a third of it; a wrong unit makes more. The law's
// height may be smaller where it is a lower bound.
std::string apogee_doubt(const Heard& heard) {
  constexpr double most_times = 2.0;
  const double law_m = heard.apogee_m;
  const double log_m = heard.log_height.apogee_m;
  const bool log_is_larger = log_m > most_times * law_m;
  if (!heard.apogee_s || !heard.log_height.apogee_s || !height_doubt(heard).empty() ||
      !(log_is_larger ? !heard.is_lower_bound : law_m > most_times * log_m)) {
    return {};
  }
  const bool like_feet = law_m > 0.0 && log_m > 2.5 * law_m && log_m < 4.0 * law_m;
  return fmt::format(
      "Up to apogee the log's own height gains {} m and the law's height {} m, a difference of more than a factor of "
      "{}. Check the unit of the height{}, and those of axial force and rates.",
      text::fixed(log_m, 0), text::fixed(law_m, 0), most_times,
      like_feet ? " (feet given as metres read 3.3 times too high)" : "");
}

std::string interval_doubt(const Heard& heard) {
  constexpr double much_s = 0.25 * (1.0 - 1e-6);  // times of a log's clock are rounded
  return heard.log.interval_s >= much_s
             ? "Samples are a quarter of a second or more apart, which is long for a flight: the time may be in "
               "milliseconds."
             : "";
}

}  // namespace

std::vector<std::string> doubts_of(const Heard& heard) {
  std::vector<std::string> doubts{heard.log.doubt,
                                  axial_doubt(heard, heard.log.axial, "the axial force", "axial"),
                                  axial_doubt(heard, heard.log.second_axial, "the second axial force", "second_axial"),
                                  disagreement_doubt(heard),
                                  begin_doubt(heard),
                                  pad_doubt(heard),
                                  flown_doubt(heard),
                                  lift_off_gap_doubt(heard),
                                  silence_doubt(heard),
                                  interval_doubt(heard),
                                  height_doubt(heard),
                                  apogee_doubt(heard),
                                  end_doubt(heard),
                                  other_flight_doubt(heard)};
  std::erase(doubts, std::string{});
  return doubts;
}

}  // namespace fantail::listen
