// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "degree.hpp"
#include "faults/judge.hpp"

namespace fantail::faults {

// A flight written by hand: ignition at 0, detection at 0.1 s, control from 0.6 s to 10 s, and the end at 11 s.

constexpr double control_begin_s = 0.6;
constexpr double control_end_s = 10.0;

constexpr Expected held = any_of(Outcome::holds);
constexpr FaultTime at_three{.begin_s = 3.0, .end_s = 3600.0};

inline core::Phase phase_at(double time_s) {
  return time_s < -5.0              ? core::Phase::safe
         : time_s < 0.1             ? core::Phase::armed
         : time_s < control_begin_s ? core::Phase::launched
         : time_s < control_end_s   ? core::Phase::controlling
                                    : core::Phase::finished;
}

/// All canards are at 2 degrees under control, at trim otherwise, and stand where they are asked to; the rocket stands
/// at 5 degrees. `truth` changes where they stand, after that.
inline std::vector<Moment> made_flight(const std::function<void(Moment& moment)>& change = {},
                                       const std::function<void(Moment& moment)>& truth = {}) {
  std::vector<Moment> flight;
  for (int ms = -6000; ms < 11000; ++ms) {
    Moment moment{.time_s = 1e-3 * ms, .phase = phase_at(1e-3 * ms), .true_roll_rad = 5.0 * degree};
    moment.commanded_rad.fill(moment.phase == core::Phase::controlling ? 2.0 * degree : 0.0);
    if (change) {
      change(moment);
    }
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      moment.true_shaft_rad[i] = moment.commanded_rad[i].value_or(0.0);
    }
    if (truth) {
      truth(moment);
    }
    flight.push_back(moment);
  }
  return flight;
}

/// Plan limit 9 degrees, all trims 0; the shafts have a play of 0.1 degrees and take 0.2 s.
inline Limits made_limits() {
  Limits limits;
  limits.limit_rad.fill(9.0 * degree);
  limits.shafts.off_rad.fill(0.1 * degree);
  limits.shafts.travel_s = 0.2;
  return limits;
}

inline Findings judged(const std::vector<Moment>& flight, const FaultTime& fault, double settle_s = 1.5,
                       const Limits& limits = made_limits()) {
  Twin twin;
  for (const Moment& moment : made_flight()) {
    twin.add(moment);
  }
  Judge judge{limits, twin, fault, settle_s};
  for (const Moment& moment : flight) {
    judge.add(moment);
  }
  return judge.findings();
}

}  // namespace fantail::faults
