// SPDX-License-Identifier: MIT
// What was heard, in a sentence.
#include <fmt/core.h>

#include "listen/lift_off.hpp"
#include "listen/sentences.hpp"
#include "text/number.hpp"

namespace fantail::listen {

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
  return *heard.since_lift_off_s(heard.detected_s) > late_s ? Finding::late : Finding::heard;
}

std::string headline(const Heard& heard) {
  const std::size_t early = heard.false_detections_s.size();
  const std::string control =
      heard.early_control_s
          ? fmt::format(
                " Before any launch control began, at {:.3f} s of the log's clock: the canards would have moved.",
                *heard.early_control_s)
          : "";
  if (!heard.lift_off_s) {
    return early == 0 ? "There is no lift-off in this log, and no launch was detected."
                      : fmt::format("There is no lift-off in this log, and {} detected all the same.{}",
                                    early == 1 ? "a launch was" : fmt::format("{} launches were", early), control);
  }
  const std::string what = early == 0   ? "nothing"
                           : early == 1 ? "one launch that was none"
                                        : fmt::format("{} launches that were none", early);
  const std::string before = text::fixed(*heard.lift_off_s - heard.log.begin_s(), 2);
  const auto since_s = heard.since_lift_off_s(heard.detected_s);
  if (!since_s) {
    return early == 0 ? "The launch was not detected."
                      : fmt::format("The launch was not detected, and {} none {}, in the {} s before it.{}",
                                    early == 1 ? "one that was" : fmt::format("{} that were", early),
                                    early == 1 ? "was" : "were", before, control);
  }
  return *since_s < 0.0 && early > 0
             ? fmt::format("Launch detected {:.3f} s before lift-off, and the flight controlled from there.", -*since_s)
             : fmt::format(
                   "Launch detected {:.3f} s after lift-off{}{}.", *since_s, *since_s > late_s ? ", which is late" : "",
                   heard.begins_at_lift_off() ? "" : fmt::format(", and {} in the {} s before it", what, before));
}

std::string lift_off_rule() {
  return fmt::format(
      "Lift-off is the first rise of the axial specific force through {} g that lasts for at least half of the next {} "
      "s and begins a push of {} m/s or more, until the force has been below {} g for {} s.",
      lift_off_g, lift_off_window_s, flight_impulse_m_s, push_end_g, push_pause_s);
}

}  // namespace fantail::listen
