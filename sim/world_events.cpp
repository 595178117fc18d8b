// SPDX-License-Identifier: MIT
#include <algorithm>

#include "sim/nearest_tick.hpp"
#include "sim/world.hpp"

// What happens to the rocket, as the world sees it, and when a run is over.
namespace fantail::sim {
namespace {

using core::Microseconds;

// A start command that the avionics has not followed by then was refused.
constexpr Microseconds start_patience{1'000'000};

}  // namespace

void World::follow_events() {
  if (scenario_.surroundings != Surroundings::flight) {
    follow_tunnel();
  } else {
    follow_flight();
  }
}

void World::follow_tunnel() {
  if (!events_.liftoff && phase_ == core::Phase::controlling) {
    events_.liftoff = now_;
  }
  const bool refused = !events_.liftoff && now_ >= ignition_ + start_patience;
  const bool lost = events_.liftoff && phase_ == core::Phase::safe;  // to a reset
  if (!end_ && (phase_ == core::Phase::finished || refused || lost)) {
    end_ = now_ + time_after_end_;
  }
}

void World::follow_flight() {
  const auto note = [this](std::optional<Microseconds>& event, const auto& happened) {
    if (!event && happened()) {
      event = now_;
    }
  };
  const AscentEvents& ascent = environment_.ascent_events();
  note(events_.liftoff, [&] { return ascent.liftoff_s.has_value(); });
  note(events_.guide_clear, [&] { return environment_.is_clear_of_guide(); });
  note(events_.burnout, [&] { return ascent.burnout_s.has_value(); });
  note(events_.apogee, [&] { return ascent.apogee_s.has_value(); });
  note(events_.parachute, [&] { return environment_.parachute_s().has_value(); });
  if (!ascent.apogee_s) {
    events_.apogee.reset();  // the motor lifts the rocket beyond it
  }
  if (!end_ && environment_.is_past_apogee()) {
    end_ = now_ + time_after_end_;
  }
  if (end_ && environment_.has_parachute_to_open()) {
    end_ = std::max(*end_, now_ + 2 * tick_time);  // the next tick shall see it
  }
  if (environment_.is_over()) {
    end_ = now_;
  }
}

}  // namespace fantail::sim
