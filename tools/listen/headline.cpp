// SPDX-License-Identifier: MIT
// The finding in a sentence.
#include <algorithm>

#include <fmt/core.h>

#include "listen/lift_off.hpp"
#include "listen/sentences.hpp"
#include "text/number.hpp"

namespace fantail::listen {

double listened_until_s(const Heard& heard) {
  return (heard.lift_off_gap ? heard.lift_off_gap->to_s : heard.lift_off_s.value_or(heard.log.begin_s())) + late_s;
}

Finding finding(const Heard& heard) {
  if (!heard.false_detections_s.empty()) {
    return heard.lift_off_s && !heard.detected_s ? Finding::imagined_and_missed : Finding::imagined;
  }
  if (!heard.lift_off_s) {
    return Finding::no_launch;
  }
  if (!heard.detected_s) {
    return Finding::missed;
  }
  // What is late even if lift-off was where its gap ends.
  return *heard.detected_s > listened_until_s(heard) ? Finding::late : Finding::heard;
}

std::string headline(const Heard& heard) {
  const std::size_t early = heard.false_detections_s.size();
  const std::string control =
      heard.early_control_s
          ? fmt::format(
                " Control began without a launch, at {:.3f} s of the log's clock: the canards would have moved.",
                *heard.early_control_s)
          : "";
  if (!heard.lift_off_s) {
    return early == 0 ? "This log has no lift-off by the rule, and no launch was detected."
                      : fmt::format("This log has no lift-off by the rule, but {} detected.{}",
                                    early == 1 ? "a launch was" : fmt::format("{} launches were", early), control);
  }
  const std::string what = early == 0   ? "no false launch"
                           : early == 1 ? "one false launch"
                                        : fmt::format("{} false launches", early);
  const double before_s = *heard.lift_off_s - heard.log.begin_s();
  double in_gaps_s = 0.0;
  for (const Gap& gap : heard.gaps) {
    in_gaps_s += std::max(0.0, std::min(gap.to_s, *heard.lift_off_s) - gap.from_s);
  }
  const std::string before =
      text::fixed(before_s, 2) + " s" +
      (in_gaps_s > 0.0 ? fmt::format(" ({} s of it without samples)", text::fixed(in_gaps_s, 2)) : "");
  if (!heard.detected_s) {
    return early == 0 ? "The launch was not detected."
                      : fmt::format("The launch was not detected, but {} {} detected in the {} before it.{}",
                                    early == 1 ? "one false launch" : fmt::format("{} false launches", early),
                                    early == 1 ? "was" : "were", before, control);
  }
  const auto& gap = heard.lift_off_gap;
  const double since_s = *heard.detected_s - *heard.lift_off_s;
  if (since_s < 0.0 && early > 0) {
    return fmt::format(
        "Launch detected {}{:.3f} s before lift-off, and the flight was controlled from that "
        "detection on.",
        gap ? "at least " : "", -since_s);
  }
  return fmt::format(
      "Launch detected {}{:.3f} s after lift-off{}{}{}.",
      gap ? fmt::format("{:.3f} s to ", std::max(0.0, *heard.detected_s - gap->to_s)) : "", since_s,
      gap ? ", which lies in a gap of the log" : "", finding(heard) == Finding::late ? ", which is late" : "",
      heard.begins_at_lift_off() ? ""
                                 : fmt::format(", with {} in the {} before {}", what, before, gap ? "the gap" : "it"));
}

std::string further_sentence(const Heard& heard) {
  const std::size_t count = heard.further_lift_offs_s.size();
  return count == 0 ? ""
                    : fmt::format(
                          "{} that would be a lift-off by the rule {} at {} s of the log's clock. Possible causes: "
                          "another launch, another stage, the shock of a parachute, the landing. Only the first push "
                          "is judged.",
                          count == 1 ? "Another push" : fmt::format("{} further pushes", count),
                          count == 1 ? "begins" : "begin, the first of them",
                          text::fixed(heard.further_lift_offs_s.front(), 2));
}

std::string lift_off_rule() {
  return fmt::format(
      "Lift-off is the first rise of the axial specific force through {0} g that meets two conditions. The force "
      "stays above it for at least half of the next {1} s. The rise begins a push of {2} m/s or more, which ends "
      "when the force has been below {3} g for {4} s. {5} s at the end of the accelerometer's range also count as "
      "such a push, and so does a push in which the log ends. Readings at the end of a range below {0} g count as "
      "above it.",
      lift_off_g, lift_off_window_s, flight_impulse_m_s, push_end_g, push_pause_s, flight_clipped_s);
}

}  // namespace fantail::listen
