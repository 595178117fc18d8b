// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "core/flight_plan.hpp"
#include "sim/scenario.hpp"

namespace fantail::sim {

/// How far the canards deflect together, as the air sees them: the mean of the four, at the largest roll commands that
/// the plan gives. Trims and servo scales of plan and vehicle that differ are in it, and the canard faults that are
/// there at lift-off; so is the stall of the canards, without roll, and what the fins take back. The play is not.
struct DeflectionRange {
  double lowest_rad = 0.0;   ///< at the largest negative command; usually negative
  double highest_rad = 0.0;  ///< at the largest positive command; usually positive; where fins reverse the roll, not
};
[[nodiscard]] DeflectionRange deflection_range(const Scenario& scenario);

/// How the canards follow the roll command together, with the canard faults that are there at lift-off.
struct CanardResponse {
  /// Deflection per command, the fins' answer apart; 1: all healthy, or up to two that do not move and a plan that lets
  /// the others do their work; below zero: most turn the other way.
  double effectiveness = 1.0;
  /// Of each canard alone, whoever does its work: 1 healthy, 0 does not move, -1 turns against the command.
  std::array<double, core::canard_count> of_each{};
  double slow_share = 0.0;  ///< of those that follow: with slow_times the lag
};
[[nodiscard]] CanardResponse canard_response(const Scenario& scenario);

}  // namespace fantail::sim
