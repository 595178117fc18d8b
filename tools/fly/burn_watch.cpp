// SPDX-License-Identifier: MIT
#include "fly/burn_watch.hpp"

#include <algorithm>
#include <numbers>

namespace fantail::fly {
namespace {

// The rest of an impulse turns no flight: many thrust curves end in a tail.
constexpr double burnt_share = 0.99;
constexpr double horizon_rad = 0.5 * std::numbers::pi;

}  // namespace

BurnWatch::BurnWatch(const sim::Scenario& scenario)
    : scenario_{scenario},
      is_over_{scenario.surroundings != sim::Surroundings::flight || (scenario.path && !scenario.path->burnout_s)} {}

bool BurnWatch::is_burnt_out(const sim::World& world, double time_s) const {
  if (world.events().burnout) {
    return true;
  }
  const sim::ThrustCurve& motor = scenario_.vehicle.motor;
  return !scenario_.path && motor.impulse_until(time_s - scenario_.pad_time_s) > burnt_share * motor.impulse_n_s();
}

void BurnWatch::look(const sim::World& world, double time_s) {
  if (is_over_ || !world.events().liftoff) {
    return;
  }
  is_over_ = is_burnt_out(world, time_s);
  if (is_over_) {
    return;
  }
  look_at_attitude(world, time_s);
  look_at_height(world, time_s);
  look_at_ground(world, time_s);
  if (world.events().parachute && !found_.parachute_s) {
    found_.parachute_s = time_s;
  }
}

void BurnWatch::look_at_attitude(const sim::World& world, double time_s) {
  const std::optional<sim::Path> path = world.path();
  const bool pushes = scenario_.path || scenario_.vehicle.motor.thrust_n(time_s - scenario_.pad_time_s) > 0.0;
  if (!path || !pushes || world.is_on_ground()) {
    return;
  }
  if (path->tilt_rad > horizon_rad) {
    found_.turned_over_s = found_.turned_over_s.value_or(time_s);
  }
  if (found_.turned_over_s) {
    found_.largest_tilt_rad = std::max(found_.largest_tilt_rad, path->tilt_rad);
  }
}

void BurnWatch::look_at_height(const sim::World& world, double time_s) {
  const double height_m = world.truth().height_m;
  if (height_m > highest_m_) {
    highest_m_ = height_m;
    highest_s_ = time_s;
    found_.rose_again = found_.rose_again || sinks_;
    sinks_ = false;
  }
  const double sunk_m = highest_m_ - height_m;
  if (!world.events().guide_clear || sunk_m < flight::BeforeBurnout::least_sunk_m) {
    return;
  }
  sinks_ = true;
  if (sunk_m > found_.sank_m) {
    found_.sank_s = highest_s_;
    found_.sank_m = sunk_m;
  }
}

void BurnWatch::look_at_ground(const sim::World& world, double time_s) {
  const bool is_up = !world.is_on_ground();
  if (is_up && found_.ground_s && !found_.left_again_s) {
    found_.left_again_s = time_s;
  } else if (was_up_ && !is_up) {
    found_.ground_s = time_s;
    found_.left_again_s.reset();
  }
  was_up_ = is_up;
}

std::optional<flight::BeforeBurnout> BurnWatch::found() const {
  return found_.happened() ? std::optional{found_} : std::nullopt;
}

}  // namespace fantail::fly
