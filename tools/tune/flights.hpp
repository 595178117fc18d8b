// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "flight/flight.hpp"
#include "report/verdict.hpp"
#include "runs/row_text.hpp"
#include "sim/scenario.hpp"
#include "tune/request.hpp"

namespace fantail::tune {

/// How far the rocket truly was from its reference.
struct RollError {
  double mean_rad = 0.0;
  double largest_rad = 0.0;
};

struct RollErrors {
  std::optional<RollError> settled{};  ///< outside of the first second of control and after each step of the reference
  std::optional<RollError> all{};      ///< under control, steps and all; empty without control
};

[[nodiscard]] RollErrors roll_errors(const flight::Flight& flight);

/// Standard deviation of the command about its mean over a fifth of a second, where roll_errors() calls it settled:
/// what the servos do for noise alone, of a flight without excitation. Empty: nothing is settled for that long.
[[nodiscard]] std::optional<double> command_noise_rad(const flight::Flight& flight);

inline void fields(runs::RowText& text, RollError& error) { text(error.mean_rad, error.largest_rad); }

/// One flight by one plan.
struct Flown {
  RollErrors errors{};
  report::Outcome outcome = report::Outcome::no_control;
  std::optional<double> allowed_tilt_end_s{};  ///< report::Verdict
  double saturated_share = 0.0;                ///< of the time under control
  flight::Extremes extremes{};
};
inline void fields(runs::RowText& text, Flown& flown) {
  text(flown.errors.settled, flown.errors.all, flown.outcome, flown.allowed_tilt_end_s, flown.saturated_share,
       flown.extremes.top_mach, flown.extremes.static_margin_calibres, flown.extremes.angle_of_attack_rad);
}

/// One rocket of the spread by both plans.
struct Pair {
  std::uint64_t seed = 0;
  double damping_m2 = 0.0;
  double torque_m = 0.0;
  Flown before{};
  Flown after{};
};
inline void fields(runs::RowText& text, Pair& pair) {
  text(pair.seed, pair.damping_m2, pair.torque_m, pair.before, pair.after);
}

/// The same rockets, with the same seeds, by the scenario's plan and by another. `look` is told how many pairs are done
/// and may throw to give up.
[[nodiscard]] std::vector<Pair> fly_pairs(const sim::Scenario& scenario, const core::FlightPlan& after,
                                          const Request& request, const std::function<void(std::size_t done)>& look);

/// The error that the plans are compared by: settled, or else of all time under control. Empty without control.
[[nodiscard]] std::optional<RollError> compared(const Flown& flown);

/// Of all flights by one plan.
struct Sum {
  std::size_t flights = 0;
  std::size_t held = 0;
  report::AllowedTiltEnds tilt_ends{};  ///< of them
  std::size_t steady = 0;               ///< held, wherever each rests and whether or not the model holds
  std::size_t off_command = 0;          ///< of them
  std::size_t outside_model = 0;        ///< of them
  std::size_t not_judged = 0;
  flight::Extremes extremes{};          ///< the worst of all
  bool is_settled = false;              ///< the errors are those of settled roll, in every flight
  std::optional<double> mean_rad{};     ///< of the flights' means; empty: some flight was not under control
  std::optional<double> largest_rad{};  ///< of all
};

[[nodiscard]] Sum sum(const std::vector<Pair>& pairs, Flown Pair::* of);

/// The same rockets by each of these plans alone.
[[nodiscard]] std::vector<Sum> fly_each(const sim::Scenario& scenario, const std::vector<core::FlightPlan>& plans,
                                        const Request& request, const std::function<void(std::size_t done)>& look);

/// The scenario with the vehicle's damping and torque times these.
[[nodiscard]] sim::Scenario with_airframe(sim::Scenario scenario, double damping_factor, double torque_factor);

/// The vehicle as it is, then the four corners of the spread. A spread of 1 is the vehicle alone.
[[nodiscard]] std::vector<sim::Scenario> corners(const sim::Scenario& scenario, double spread);

/// With the middles of the spread's four sides, too.
[[nodiscard]] std::vector<sim::Scenario> corners_and_middles(const sim::Scenario& scenario, double spread);

/// One rocket of the spread: both factors log-uniform, by the seed, which is also that of the flight.
[[nodiscard]] sim::Scenario drawn(const sim::Scenario& scenario, double spread, std::uint64_t seed);

}  // namespace fantail::tune
