// SPDX-License-Identifier: MIT
#include "fly/to_ground.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "sim/nearest_tick.hpp"

namespace fantail::fly {
namespace {

sim::Scenario to_the_ground(sim::Scenario scenario) {
  scenario.time_after_end_s = longest_fall_s;
  return scenario;
}

}  // namespace

bool has_parachute(const sim::Vehicle& vehicle) { return vehicle.recovery && vehicle.recovery->drag_area_m2 > 0.0; }

ToGround::ToGround(const sim::Scenario& scenario)
    : scenario_{to_the_ground(scenario)}, world_{scenario_}, ignition_{sim::nearest_tick(scenario.pad_time_s)} {}

bool ToGround::tick() {
  if (has_begun_) {
    world_.advance();
  }
  has_begun_ = true;
  if (is_over_ || world_.over()) {
    return false;
  }
  const sim::World::Events& events = world_.events();
  // Under the parachute the avionics only hold trim, so that its ticks change nothing and take most of the time. Until
  // then they are needed: a tick is what notes that it opens.
  if (!ascent_until_ || !is_finished_ || !events.parachute) {
    is_finished_ = world_.tick().phase == core::Phase::finished;
  }
  if (!ascent_until_ && events.burnout && events.apogee) {
    ascent_until_ = std::max(*events.burnout, *events.apogee);
  }
  is_over_ = ascent_until_ && (world_.is_on_ground() || !has_parachute(scenario_.vehicle));
  if (is_over_ && events.parachute) {
    landing_m_ = world_.path().value().position_m;
  }
  return true;
}

bool ToGround::is_ascent() const {
  return world_.now() >= ignition_ && (!ascent_until_ || world_.now() < *ascent_until_);
}

double ToGround::after_ignition_s(core::Microseconds time) const { return sim::in_seconds(time - ignition_); }

flight::PathPoint path_point(const sim::Path& path, double time_s) {
  const sim::Vector3& at = path.position_m;
  const sim::Vector3& speed = path.velocity_m_s;
  return {.time_s = time_s,
          .north_m = at.x,
          .east_m = -at.y,
          .height_m = at.z,
          .north_m_s = speed.x,
          .east_m_s = -speed.y,
          .up_m_s = speed.z,
          .tilt_rad = path.tilt_rad,
          .tilt_from_guide_rad = path.tilt_from_guide_rad,
          .angle_of_attack_rad = path.angle_of_attack_rad};
}

void add_descent(flight::Flight& flight, sim::World& world, const sim::Scenario& scenario) {
  constexpr std::int64_t ticks_between_points = 100;
  constexpr auto longest_ticks = static_cast<std::int64_t>(1e3 * longest_fall_s);
  if (scenario.motion != sim::FlightMotion::six_dof || scenario.path || !has_parachute(scenario.vehicle) ||
      !world.events().apogee) {
    return;
  }
  for (std::int64_t ticks = 0; ticks < longest_ticks && !world.is_on_ground(); ++ticks) {
    if (!world.events().parachute) {
      world.tick();  // which notes that it opens
    } else if (ticks % ticks_between_points == 0) {
      flight.path.push_back(path_point(*world.path(), sim::in_seconds(world.now())));
    }
    world.advance();
  }
  if (world.is_on_ground()) {
    flight.path.push_back(path_point(*world.path(), sim::in_seconds(world.now())));
  }
  const auto& opened = world.events().parachute;
  flight.events.parachute_s = opened ? std::optional{sim::in_seconds(*opened)} : std::nullopt;
}

std::optional<sim::Vector3> landing_m(const sim::Scenario& scenario) {
  ToGround flight{scenario};
  while (flight.tick()) {
  }
  return flight.landing_m();
}

}  // namespace fantail::fly
