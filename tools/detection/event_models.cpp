// SPDX-License-Identifier: MIT
#include "detection/event_models.hpp"

#include "detection/shapes.hpp"
#include "sim/units.hpp"

namespace fantail::detection {

Streams streams_of(std::uint64_t seed, Kind kind, std::uint64_t event) {
  const std::uint64_t of_kind = sim::Random{seed, index(kind)}.bits();
  const std::uint64_t of_event = sim::Random{of_kind, event}.bits();
  return {.model = {of_event, 0}, .across = {of_event, 1}, .axial = {of_event, 2}, .others = {of_event, 3}};
}

void make_event(Kind kind, Streams& streams, Motion& motion, bool all) {
  sim::Random& random = streams.model;
  switch (kind) {
    case Kind::handling: return make_handling(random, motion);
    case Kind::drop: return make_drop(random, motion);
    case Kind::transport: return make_transport(streams, motion, all);
    case Kind::shaking: return make_shaking(random, motion);
    case Kind::chuff: return make_chuff(streams, motion, all);
    case Kind::misfire: return make_misfire(streams, motion, all);
    case Kind::neighbour: return make_neighbour(streams, motion, all);
    case Kind::gust: return make_gust(random, motion);
    case Kind::vibration: return make_vibration(streams, motion, all);
    case Kind::bias: return motion.begin(steps(1.5), uniform(random, 0.0, 15.0 * sim::radians_per_degree));
    case Kind::tilt: return make_tilt(random, motion);
    case Kind::launch:
    case Kind::launch_one_bad: return make_launch(streams, motion, -1.0, all);
    case Kind::launch_at_2_g: return make_launch(streams, motion, 2.0, all);
    case Kind::raised_rail: return make_raised_rail(streams, motion, all);
    case Kind::stirred_launch: return make_stirred_launch(streams, motion, all);
    case Kind::missed_flight: return make_missed_flight(streams, motion, all);
    case Kind::uncontrolled_flight: return make_uncontrolled_flight(streams, motion, all);
  }
}

}  // namespace fantail::detection
