// SPDX-License-Identifier: MIT
#pragma once

#include "synthetic_flight.hpp"

namespace fantail::report {

inline constexpr double opens_s = 1.0;
inline constexpr double settles_deg = -10.0;  // u_d -5 deg, kp 0.5

/// The synthetic flight with a gate by burn-out: dormant from 0.6 s to 1.0 s.
inline SyntheticFlight dormant_flight() {
  SyntheticFlight made;
  flight::Flight& flight = made.flight;
  flight.plan.dormancy.until = core::DormantUntil::burn_out;
  made.each_controlled(
      [](flight::Row& row) { row.phase = row.time_s < opens_s ? core::Phase::dormant : core::Phase::controlling; });
  flight.events.dormant_s = 0.6;
  flight.events.control_start_s = opens_s;
  flight.phase_changes.back().phase = core::Phase::dormant;
  flight.phase_changes.push_back({opens_s, core::Phase::controlling, core::PhaseReason::gate_open});
  return made;
}

}  // namespace fantail::report
