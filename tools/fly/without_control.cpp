// SPDX-License-Identifier: MIT
#include <cstdint>

#include "fly/fly_scenario.hpp"
#include "sim/lean_board.hpp"
#include "sim/world.hpp"

namespace fantail::fly {
namespace {

// Does this law move the canards by itself?
bool moves_canards(const core::FlightPlan& plan) {
  return plan.controller.proportional_gain != 0.0F || plan.controller.derivative_gain_s != 0.0F ||
         plan.offset.rejection != core::OffsetRejection::none || plan.excitation.form != core::ExcitationForm::none;
}

sim::Scenario uncontrolled(const sim::Scenario& scenario) {
  sim::Scenario free = scenario;
  free.plan.controller.proportional_gain = 0.0F;
  free.plan.controller.derivative_gain_s = 0.0F;
  free.plan.controller.entry = core::ControlEntry::as_published;  // capture needs a gain
  free.plan.offset.rejection = core::OffsetRejection::none;
  free.plan.excitation.form = core::ExcitationForm::none;
  return free;
}

}  // namespace

std::vector<flight::FreeRollPoint> roll_without_control(const sim::Scenario& scenario, const flight::Flight& flight,
                                                        const Look& look) {
  constexpr std::int64_t ticks_between_looks = 1024;
  constexpr std::int64_t ticks_between_points = 10;  // however few rows the flight keeps: its figures do not change
  std::vector<flight::FreeRollPoint> points;
  if (!flight.events.control_start_s || scenario.surroundings == sim::Surroundings::gimbal || scenario.pin ||
      !moves_canards(scenario.plan)) {
    return points;
  }
  const sim::Scenario free = uncontrolled(scenario);
  sim::World world{free, sim::World::small_flash, sim::unrecorded_board(free)};
  for (std::int64_t ticks = 0; !world.over(); ++ticks) {
    (void)world.tick();
    if (ticks % ticks_between_points == 0) {
      const sim::Truth truth = world.truth();
      const double time_s = 1e-6 * static_cast<double>(world.now().count());
      points.push_back({flight.clock(time_s), truth.roll_angle_rad, truth.roll_rate_rad_s});
    }
    if (look && ticks % ticks_between_looks == 0) {
      look(1e-6 * static_cast<double>(world.now().count()));
    }
    world.advance();
  }
  return points;
}

}  // namespace fantail::fly
