// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/flight_phase.hpp"
#include "listen/imu_log.hpp"
#include "listen/range_end.hpp"
#include "listen/sensors.hpp"

namespace fantail::listen {

/// A phase that the law entered. Times are the log's clock; height, speed and tilt the law's estimates then.
struct Event {
  double time_s = 0.0;
  core::Phase to{};
  core::PhaseReason reason{};
  double height_m = 0.0;
  double speed_m_s = 0.0;  ///< along the guide
  double tilt_rad = 0.0;
};

/// The law's estimates, every 10 ms around the flight.
struct Trace {
  std::vector<double> time_s{};  ///< log's clock
  std::vector<double> axial_m_s2{};
  std::vector<double> height_m{};
  std::vector<double> speed_m_s{};
  std::vector<double> tilt_rad{};
  std::vector<double> roll_rate_rad_s{};
};

/// An axis that seems to stand at the end of its range, and whose it is.
struct Clipped {
  std::string what{};  ///< "axial", "roll_rate"
  RangeEnd end{};
};

struct Peak {
  double value = 0.0;
  double time_s = 0.0;
};

/// For how long two accelerometers differed by more than the plan allows.
struct Disagreement {
  double first_s = 0.0;  ///< log's clock
  double in_all_s = 0.0;
};

/// A log, flown through the law.
struct Heard {
  ImuLog log{};
  std::string plan{};  ///< its name
  core::FlightPlan flown{};
  double longest_bridge_s = 0.0;
  std::vector<Gap> gaps{};  ///< of the axial force
  std::vector<Clipped> clipped{};

  /// By the rule of lift_off.hpp, log's clock. Where that is in a gap: the gap, and here its begin.
  std::optional<double> lift_off_s{};
  std::optional<Gap> lift_off_gap{};
  std::vector<double> further_lift_offs_s{};  ///< by the same rule; none of them is judged
  std::vector<Event> events{};                ///< from Armed on
  std::vector<double> false_detections_s{};
  /// The first Launched that is none of these, or the one of these in which the law still was at lift-off, if it went
  /// on from there to Controlling.
  std::optional<double> detected_s{};
  std::optional<double> early_control_s{};  ///< Controlling before lift-off, or in a log without one
  std::optional<Event> control{};           ///< the first Controlling after it
  Disagreement no_hold{};       ///< while the law listened, between lift-off and late_s behind it: its hold began again
  Disagreement no_control{};    ///< in Launched, beyond the guide: control did not begin for it
  double longest_rest_s = 0.0;  ///< that the law saw before lift-off, or in the whole log
  std::optional<double> apogee_s{};  ///< by the law: its vertical speed changes its sign
  double apogee_m = 0.0;
  double tilt_at_apogee_rad = 0.0;
  bool is_lower_bound = false;        ///< height and speed at apogee, or at the end, as the law says itself
  Peak fastest{};                     ///< m/s along the guide, up to apogee
  Peak hardest{};                     ///< m/s2, axial, between lift-off and top speed (without control: and apogee)
  std::optional<Peak> log_fastest{};  ///< m/s, of the log's own speed in the same time
  LogHeight log_height{};
  Trace trace{};
  std::vector<std::string> doubts{};  ///< why the finding may be wrong, a sentence each
  std::vector<std::string> notes{};   ///< what a reader must know, a sentence each

  /// Does the log seem to begin in thrust?
  [[nodiscard]] bool begins_at_lift_off() const { return lift_off_s && !lift_off_gap && *lift_off_s <= log.begin_s(); }

  /// Empty also where it lies in a gap.
  [[nodiscard]] std::optional<double> known_lift_off_s() const { return lift_off_gap ? std::nullopt : lift_off_s; }
  /// After lift-off, where that is known.
  [[nodiscard]] std::optional<double> since_lift_off_s(std::optional<double> time_s) const {
    return time_s && known_lift_off_s() ? std::optional{*time_s - *lift_off_s} : std::nullopt;
  }
};

}  // namespace fantail::listen
