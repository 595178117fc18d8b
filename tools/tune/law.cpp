// SPDX-License-Identifier: MIT
#include "tune/law.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/core.h>

#include "core/flight_plan_fields.hpp"
#include "text/error.hpp"

namespace fantail::tune {
namespace {

core::RollModelPlan roll_model(const sim::Scenario& scenario) {
  const sim::RollPlant& plant = scenario.vehicle.roll_plant;
  const auto after_burnout_kg_m2 = scenario.vehicle.airframe.value_or(sim::Airframe{}).roll_inertia_after_burnout_kg_m2;
  return {.roll_inertia_kg_m2 = static_cast<float>(after_burnout_kg_m2.value_or(plant.inertia_kg_m2)),
          .reference_area_m2 = static_cast<float>(plant.reference_area_m2),
          .damping_m2 = static_cast<float>(plant.damping_m2),
          .torque_m = static_cast<float>(plant.torque_m),
          .density_kg_m3 = static_cast<float>(scenario.atmosphere.density_kg_m3(0.0))};
}

}  // namespace

std::string schedules_left_out(const stability::SpeedRange& range) {
  if (!stability::has_room_for_schedule(range)) {
    return "";
  }
  std::string powers;
  for (const double exponent : stability::schedule_exponents) {
    if (!stability::is_within_plan(exponent, range)) {
      powers += fmt::format("{}{}", powers.empty() ? "" : " and ", exponent);
    }
  }
  const double most = stability::schedule_exponents.back();
  return powers.empty()
             ? ""
             : fmt::format(
                   "Not tried: gains that fall with the speed to the power of {}. They need a factor of up to {:.0f} "
                   "at "
                   "{:.1f} m/s, and a plan allows at most {:.0f}. Control that begins at {:.1f} m/s or faster allows "
                   "them (guide.minimum_speed_m_s).",
                   powers, stability::factor_at_lowest_speed(most, range), range.lowest_m_s,
                   stability::largest_schedule_factor(),
                   std::ceil(10.0 * range.highest_m_s / std::pow(stability::largest_schedule_factor(), 1.0 / most)) /
                       10.0);
}

core::FlightPlan with_law(const sim::Scenario& scenario, core::OffsetRejection rejection, const Law& law,
                          const stability::SpeedRange& range) {
  core::FlightPlan plan = scenario.plan;
  plan.controller.proportional_gain = static_cast<float>(law.gains.proportional);
  plan.controller.derivative_gain_s = static_cast<float>(law.gains.derivative_s);
  plan.gain_schedule = stability::gain_schedule(law.schedule_exponent, range);
  plan.offset.rejection = rejection;
  if (rejection == core::OffsetRejection::integral) {
    plan.offset.integral_gain_per_s = static_cast<float>(law.integral_gain_per_s);
  } else if (rejection == core::OffsetRejection::observer) {
    plan.offset.observer_bandwidth_rad_s = static_cast<float>(law.observer_bandwidth_rad_s);
  }
  // A rocket that waited turns when its canards may move, and the old plan may have left it to turn back every turn.
  if (plan.run.start == core::Start::launch && plan.dormancy.until != core::DormantUntil::guide) {
    plan.controller.entry = core::ControlEntry::capture;
  }
  if (rejection == core::OffsetRejection::observer || plan.controller.entry == core::ControlEntry::capture) {
    plan.roll_model = roll_model(scenario);
  }
  if (const auto fault = core::validate(plan)) {
    const core::PlanField& field = core::flight_plan_fields()[fault->field];
    throw text::Error{text::ErrorKind::bad_configuration,
                      scenario.name + ": the tuned law does not fit into a plan: " + std::string{field.section} + "." +
                          std::string{field.key} + " is refused: " + std::string{core::sentence(fault->rule)}};
  }
  return plan;
}

}  // namespace fantail::tune
