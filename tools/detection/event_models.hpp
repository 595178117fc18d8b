// SPDX-License-Identifier: MIT
#pragma once

#include "detection/kind.hpp"
#include "detection/motion.hpp"
#include "sim/random.hpp"

namespace fantail::detection {

/// The random streams of one event; each has its own, so that what needs only the axis may leave the others undrawn.
struct Streams {
  sim::Random model;   ///< what happens
  sim::Random across;  ///< noise across the axis
  sim::Random axial;   ///< errors and noise of the two axial channels
  sim::Random others;  ///< noise of all other channels
};
[[nodiscard]] Streams streams_of(std::uint64_t seed, Kind kind, std::uint64_t event);

/// Every event begins with this long at rest.
inline constexpr double lead_s = 0.2;

/// Draws one event of this kind. Without `all` the accelerations across the axis lack their noise; nothing else does.
void make_event(Kind kind, Streams& streams, Motion& motion, bool all);

// One a kind; ranges, sources and weaknesses are in kind_table.
void make_handling(sim::Random& random, Motion& motion);
void make_drop(sim::Random& random, Motion& motion);
void make_transport(Streams& streams, Motion& motion, bool all);
void make_shaking(sim::Random& random, Motion& motion);
void make_chuff(Streams& streams, Motion& motion, bool all);
void make_misfire(Streams& streams, Motion& motion, bool all);
void make_neighbour(Streams& streams, Motion& motion, bool all);
void make_gust(sim::Random& random, Motion& motion);
void make_vibration(Streams& streams, Motion& motion, bool all);
void make_tilt(sim::Random& random, Motion& motion);

/// Shaken along its axis in these steps, at this share of the bounds or more.
void add_shaking(sim::Random& random, Motion& motion, std::size_t first, std::size_t last, double least_share);

/// `rms_g`: of the vibration; negative: drawn, 0 to 2.
void make_launch(Streams& streams, Motion& motion, double rms_g, bool all);
void make_raised_rail(Streams& streams, Motion& motion, bool all);
void make_stirred_launch(Streams& streams, Motion& motion, bool all);

void make_missed_flight(Streams& streams, Motion& motion, bool all);
void make_uncontrolled_flight(Streams& streams, Motion& motion, bool all);

}  // namespace fantail::detection
