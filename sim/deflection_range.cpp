// SPDX-License-Identifier: MIT
#include "sim/deflection_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/flight_plan.hpp"
#include "sim/canard_aerodynamics.hpp"
#include "sim/canard_set.hpp"
#include "sim/random_streams.hpp"
#include "sim/servo.hpp"

namespace fantail::sim {
namespace {

constexpr std::size_t canards = core::canard_count;

/// The one that is in force at lift-off: a later fault of a gear takes the place of an earlier one. Null: none.
const GearFault* fault_of(const Scenario& scenario, std::size_t canard) {
  const Fault* last = nullptr;
  for (const Fault& fault : scenario.faults) {
    if (fault.canard == canard && broken_gear(fault) != nullptr && is_there_at_liftoff(fault) &&
        (last == nullptr || fault.from_s >= last->from_s)) {
      last = &fault;
    }
  }
  return last == nullptr ? nullptr : broken_gear(*last);
}

/// What the pulse of the plan makes of a healthy servo.
double commanded_shaft_rad(const core::FlightPlan& plan, const ServoParameters& servo, std::size_t canard,
                           double command_rad) {
  const core::CanardPlan& own = plan.canards.each[canard];
  const auto limit_rad = static_cast<double>(
      std::min({plan.controller.canard_limit, core::hard_canard_limit, own.mechanical_stop}).radians());
  const double turned = own.direction == core::Direction::reversed ? -1.0 : 1.0;
  const double asked_rad =
      std::clamp(turned * command_rad + static_cast<double>(own.trim.radians()), -limit_rad, limit_rad);
  const double pulse_us =
      static_cast<double>(own.pulse_centre_us) + static_cast<double>(own.pulse_per_radian_us) * asked_rad;
  return servo.centre_rad + radians_per_degree * (pulse_us - servo.pulse_centre_us) / servo.pulse_per_degree_us;
}

using Servos = std::array<ServoParameters, canards>;

double shaft_rad(const Scenario& scenario, const Servos& servos, std::size_t canard, double command_rad) {
  const ServoParameters& servo = servos[canard];
  const double at_rest_rad = commanded_shaft_rad(scenario.plan, servo, canard, 0.0);
  double angle_rad = commanded_shaft_rad(scenario.plan, servo, canard, command_rad);
  if (const GearFault* gear = fault_of(scenario, canard)) {
    switch (gear->fault) {
      case ServoFault::stuck: angle_rad = gear->angle_rad.value_or(at_rest_rad); break;
      case ServoFault::hardover: angle_rad = servo.stop_rad; break;
      case ServoFault::dead: angle_rad = 0.0; break;
      case ServoFault::slipping: angle_rad = at_rest_rad + slipping_grip * (angle_rad - at_rest_rad); break;
      case ServoFault::reversed: angle_rad = 2.0 * servo.centre_rad - angle_rad; break;
      case ServoFault::wrong_trim: angle_rad += gear->angle_rad.value_or(usual_wrong_trim_rad); break;
      default: break;  // a slow one gets there, too
    }
  }
  return std::clamp(angle_rad, -servo.stop_rad, servo.stop_rad);
}

double deflection_rad(const Scenario& scenario, const Servos& servos, std::size_t canard, double command_rad) {
  const CanardMounting& mounting = scenario.vehicle.canards[canard];
  const double from_trim_rad =
      lift_angle_rad(scenario.vehicle.canard_air, shaft_rad(scenario, servos, canard, command_rad) - mounting.trim_rad);
  return mounting.reversed ? -from_trim_rad : from_trim_rad;
}

double deflection_rad(const Scenario& scenario, const Servos& servos, double command_rad) {
  double sum_rad = 0.0;
  for (std::size_t i = 0; i < canards; ++i) {
    sum_rad += deflection_rad(scenario, servos, i, command_rad);
  }
  return sum_rad / static_cast<double>(canards);
}

/// As the world draws them.
Servos servos_of(const Scenario& scenario) {
  return drawn_servos(scenario.vehicle, Random{scenario.seed, RandomStream::servo_spread});
}

}  // namespace

DeflectionRange deflection_range(const Scenario& scenario) {
  const auto largest_rad =
      static_cast<double>(std::min(scenario.plan.controller.canard_limit, core::hard_canard_limit).radians());
  const Servos servos = servos_of(scenario);
  const double left = left_by_fins(scenario.vehicle.canard_air);
  return {.lowest_rad = left * deflection_rad(scenario, servos, -largest_rad),
          .highest_rad = left * deflection_rad(scenario, servos, largest_rad)};
}

CanardResponse canard_response(const Scenario& scenario) {
  // Where nothing ends at a stop or a limit.
  constexpr double small_rad = 0.001 * radians_per_degree;
  const Servos servos = servos_of(scenario);
  CanardResponse response;
  response.effectiveness =
      (deflection_rad(scenario, servos, small_rad) - deflection_rad(scenario, servos, -small_rad)) / (2.0 * small_rad);
  for (std::size_t i = 0; i < canards; ++i) {
    response.of_each[i] =
        (deflection_rad(scenario, servos, i, small_rad) - deflection_rad(scenario, servos, i, -small_rad)) /
        (2.0 * small_rad);
  }
  double follow = 0.0;
  double slow = 0.0;
  for (std::size_t i = 0; i < canards; ++i) {
    const GearFault* gear = fault_of(scenario, i);
    const auto is = [gear](ServoFault fault) { return gear != nullptr && gear->fault == fault; };
    follow += is(ServoFault::stuck) || is(ServoFault::hardover) || is(ServoFault::dead) ? 0.0 : 1.0;
    slow += is(ServoFault::slow) ? 1.0 : 0.0;
  }
  response.slow_share = follow > 0.0 ? slow / follow : 0.0;
  // Those that follow do the work of the others as well, once the monitor has seen it.
  if (scenario.plan.run.canard_fault == core::CanardFaultPolicy::share && follow >= 2.0) {
    response.effectiveness *= static_cast<double>(canards) / follow;
  }
  return response;
}

}  // namespace fantail::sim
