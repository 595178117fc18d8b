// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "core/flight_plan_fields.hpp"
#include "figures.hpp"
#include "flight/flight.hpp"
#include "report/verdict.hpp"
#include "text/degrees.hpp"

namespace fantail::report {

/// A hand-made flight: 1 kHz from -0.5 s to 4.5 s, detected at 0.2 s, control from 0.6 s to the end of the rows (3901
/// ticks) at apogee, disturbance -5 deg, gain 0.5, limit 9 deg, reference 0, and under control the roll angle exactly
/// at its settle point of -10 deg.
class SyntheticFlight {
 public:
  SyntheticFlight() {
    flight.scenario = "synthetic";
    flight.vehicle = "paper dart";
    flight.plan_name = "by hand";
    flight.version = "0.0.0";
    flight.seed = 7;
    flight.plan = core::default_plan();
    flight.plan.controller.proportional_gain = 0.5F;
    flight.plan.controller.canard_limit = core::Angle::from_degrees(9.0F);
    flight.events = {.liftoff_s = 0.0, .detected_s = 0.2, .control_start_s = 0.6, .apogee_s = 4.5};
    flight.phase_changes = {{-0.5, core::Phase::armed, core::PhaseReason::armed_by_switch_and_command},
                            {0.2, core::Phase::launched, core::PhaseReason::launch_detected},
                            {0.6, core::Phase::controlling, core::PhaseReason::guide_clear}};
    for (int tick = 0; tick <= 5000; ++tick) {
      flight::Row row;
      row.time_s = (tick - 500) / 1000.0;
      row.phase = tick < 700 ? core::Phase::armed : tick < 1100 ? core::Phase::launched : core::Phase::controlling;
      row.roll_angle_rad = text::radians(tick < 1100 ? 0.0 : -10.0);
      row.truth = flight::Truth{.roll_angle_rad = row.roll_angle_rad, .disturbance_rad = text::radians(-5.0)};
      flight.rows.push_back(row);
    }
  }

  void each_controlled(const std::function<void(flight::Row&)>& change) {
    for (flight::Row& row : flight.rows) {
      if (row.phase == core::Phase::controlling) {
        change(row);
      }
    }
  }

  /// The flight as if control had ended at a time.
  void end_control(double time_s, core::PhaseReason reason) {
    each_controlled([time_s](flight::Row& row) {
      if (row.time_s >= time_s) {
        row.phase = core::Phase::finished;
      }
    });
    flight.events.control_end_s = time_s;
    flight.phase_changes.push_back({time_s, core::Phase::finished, reason});
  }

  /// The flight as if it had stayed in one phase since a change for this reason.
  void never_controlled(double time_s, core::Phase phase, core::PhaseReason reason) {
    each_controlled([phase](flight::Row& row) { row.phase = phase; });
    flight.events.control_start_s.reset();
    flight.phase_changes.back() = {time_s, phase, reason};
  }

  flight::Flight flight;
};

inline Verdict verdict_of(const flight::Flight& flight) { return verdict(flight, figures(flight)); }

/// Those of its sentences, in their order. A steady flight that is not changed has 10.0 deg from the command, 0.0 deg
/// from where the law settles, 0.0 % at the limit and 4.0 deg to spare.
inline Numbers numbers(const Verdict& v) { return fantail::figures(v.text); }

inline bool says(const Verdict& v, std::string_view word) { return v.text.find(word) != std::string::npos; }

}  // namespace fantail::report
