// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "identify/identification.hpp"
#include "paper/claim.hpp"
#include "paper/runs.hpp"
#include "report/results.hpp"

namespace fantail::paper {

/// Whether a lower offset at the begin of a tunnel step can come from canard-fin interaction, as printed: a step flown
/// with fins that take back a share of the canards' torque later, and identified with the published model, which knows
/// no such thing.
[[nodiscard]] Claim canard_fin_interaction(const Tell& tell);

/// What slows a rocket that coasts straight up.
struct Coasting {
  double drag_per_mass_1_m = 0.0;  ///< 1/2 rho CdA / m: the deceleration is this times the speed squared, plus gravity
};

/// The least time in which any motor can bring a rocket `height_m` up and to rest there without it ever being faster
/// than `top_speed_m_s`: top speed from the first instant, held by thrust, then a coast. The thrust is never negative,
/// so nothing stops sooner than a coast: no ascent with at most this drag takes less.
[[nodiscard]] double least_time_to_apogee_s(double height_m, double top_speed_m_s, const Coasting& coasting);

/// Height, speed and times of the first launch beside those of its simulated flight.
[[nodiscard]] std::vector<Claim> first_launch_ascent(const Run& run, const report::Figures& figures);

/// Eq 35 and 36: even intervals to the end of thrust, and from there to the end of the data. The first time is 0.
[[nodiscard]] identify::model::NodeTimes times_in_thrust_and_coast(double thrust_s, std::size_t in_thrust, double end_s,
                                                                   std::size_t in_coast);

struct FirstLaunchIdentified {
  const identify::model::Record& record;
  const identify::model::Airframe& rocket;
  double thrust_s = 0.0;  ///< from the begin of the record
  const identify::result::Identification& open;
  const identify::result::Identification& closed;
};

/// What was identified in the first launch, beside what is found in its simulated flight.
[[nodiscard]] std::vector<Claim> first_launch_identified(const FirstLaunchIdentified& ours);

/// Section 4.3.2's search for the number of disturbance intervals N1: over the constant offset of the simulated flight,
/// and over one that varies. `window` is the first window of the flight `run`.
[[nodiscard]] std::vector<Claim> offset_intervals(const identify::model::Record& window, const Run& run);

/// What so many intervals leave of angle and rate over the one that varies, which was fitted to the first window.
struct PrintedErrors {
  std::string place;
  std::string what;
  double angle_deg;
  double rate_deg_s;
  std::string why;
};
[[nodiscard]] Claim errors_over_a_wave(const PrintedErrors& printed, const identify::model::Record& window,
                                       const Run& run, std::size_t intervals);

/// Signs, units, repeated and contradicting numbers, each with what it must read.
[[nodiscard]] std::vector<Claim> print_slips();

}  // namespace fantail::paper
