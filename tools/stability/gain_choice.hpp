// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "stability/roll_loop.hpp"

namespace fantail::stability {

struct Gains {
  double proportional = 0.0;  ///< kp
  double derivative_s = 0.0;  ///< kd
};

/// The largest that a plan may have.
[[nodiscard]] Gains largest_gains();

/// What gains must give: this phase margin in this share of the airframes at every air speed. A loop whose gain never
/// reaches one cannot swing and has it.
struct PhaseMarginDemand {
  double phase_margin_rad = 0.0;
  double share = 1.0;  ///< of the airframes, above zero
};

/// The loops of all airframes at each air speed. Their own kp and kd are not looked at; integral gain, observer and
/// factor of the schedule stay what they are.
using LoopsAtSpeeds = std::vector<std::vector<RollLoop>>;

[[nodiscard]] bool meets(const LoopsAtSpeeds& loops, const Gains& gains, const PhaseMarginDemand& demand);

/// Which gains may differ from the present ones.
enum class Search : std::uint8_t { both_gains, derivative_gain };

/// Of the gains from the least to the largest allowed, those that are fewest times larger or smaller than the present
/// ones. They are round numbers, 24 in a decade, or one of the present ones kept. A proportional gain of zero is kept,
/// and no other one becomes zero: it would leave the angle alone. Empty when no pair meets the demand.
[[nodiscard]] std::optional<Gains> nearest_gains(const LoopsAtSpeeds& loops, const Gains& present, const Gains& largest,
                                                 const PhaseMarginDemand& demand, Search search = Search::both_gains);

/// The longest servo lag with which these gains meet the demand, in whole tenths of a millisecond, from the shortest
/// that is asked for to that of the loops. Empty when not even the shortest does.
[[nodiscard]] std::optional<double> longest_servo_lag_s(const LoopsAtSpeeds& loops, const Gains& gains,
                                                        double shortest_s, const PhaseMarginDemand& demand);

/// The preferred numbers of IEC 60063, E24, from one end to the other, increasing: neighbours differ by a tenth.
[[nodiscard]] std::vector<double> round_numbers_between(double from, double to);

}  // namespace fantail::stability
