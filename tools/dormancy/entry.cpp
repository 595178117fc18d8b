// SPDX-License-Identifier: MIT
#include "dormancy/entry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/gain_schedule.hpp"
#include "core/roll_reference.hpp"
#include "sim/deflection_range.hpp"
#include "stability/canard_sense.hpp"
#include "stability/roll_loop.hpp"

namespace fantail::dormancy {
namespace {

/// Within a tenth, and then what core::Capture makes of a spin is what the vehicle's own would be.
bool is_model_of(const core::RollModelPlan& model, const sim::RollPlant& plant) {
  const auto is_near = [](double one, double other) { return std::abs(one - other) <= 0.1 * other; };
  const auto damping_m2 = static_cast<double>(model.damping_m2);
  const auto inertia_m2 = static_cast<double>(model.roll_inertia_kg_m2) / static_cast<double>(model.reference_area_m2);
  return model.torque_m > 0.0F &&
         is_near(damping_m2 / static_cast<double>(model.torque_m), plant.damping_m2 / plant.torque_m) &&
         is_near(inertia_m2 / damping_m2, plant.inertia_kg_m2 / plant.reference_area_m2 / plant.damping_m2);
}

/// From when on the reference, the excitation or nothing at all disturbs a capture.
double undisturbed_s(const core::FlightPlan& plan) {
  double until_s = std::numeric_limits<double>::infinity();
  const auto end_at = [&until_s](core::Microseconds time) {
    until_s = std::min(until_s, static_cast<double>(core::seconds(time)));
  };
  if (plan.excitation.form != core::ExcitationForm::none) {
    end_at(plan.excitation.begin);
  }
  const core::ReferencePlan& reference = plan.reference;
  if (reference.kind == core::ReferenceKind::steps && reference.step_times_count > 0) {
    end_at(reference.step_times[0]);
  } else if (reference.kind == core::ReferenceKind::square_wave) {
    end_at(reference.square_wave_begin);
  }
  return until_s;
}

std::optional<double> share_of(const RollAtEntry& e, const core::ControllerPlan& plan, double waited_s) {
  constexpr double largest = 0.9;
  if (!e.has_model) {
    return std::copysign(0.5, e.rate_rad_s);
  }
  return waited_s >= offset_known_after_s
             ? std::optional{std::clamp(e.offset_rad / static_cast<double>(plan.canard_limit.radians()), -largest,
                                        largest)}
             : std::nullopt;
}

}  // namespace

RollAtEntry entry_of(const sim::Scenario& scenario, const Outlook& outlook) {
  const Opening& opening = outlook.opening.value();
  const sim::Vehicle& vehicle = scenario.vehicle;
  const core::FlightPlan& plan = scenario.plan;
  const sim::DeflectionRange reach = sim::deflection_range(scenario);
  const double factor =
      static_cast<double>(core::gain_factor(plan.gain_schedule, static_cast<float>(opening.speed_m_s), false)) *
      stability::left_in_the_end(scenario);
  const double mach = opening.speed_m_s / scenario.atmosphere.speed_of_sound_m_s(opening.height_m);
  const double drag_area_m2 =
      vehicle.drag_area_m2 * (vehicle.drag_over_mach.is_there() ? vehicle.drag_over_mach.at(mach) : 1.0);
  RollAtEntry e{
      .plant = vehicle.roll_plant,
      .density_kg_m3 = scenario.atmosphere.density_kg_m3(opening.height_m),
      .speed_m_s = opening.speed_m_s,
      .drag_per_mass_m2_kg = std::max(1e-9, drag_area_m2 / (vehicle.mass_kg - vehicle.motor.propellant_kg())),
      .rate_rad_s = opening.rate_rad_s,
      .ahead_rad = opening.angle_rad - static_cast<double>(core::roll_reference(plan.reference, {}).radians()),
      .offset_rad = opening.offset_rad,
      .limit_rad = std::min(reach.highest_rad, -reach.lowest_rad),
      .proportional_gain = factor * static_cast<double>(plan.controller.proportional_gain),
      .derivative_gain_s = factor * static_cast<double>(plan.controller.derivative_gain_s),
      .servo_lag_s = vehicle.servo.lag_s,
      .delay_s = stability::loop_delay_s(vehicle),
      .has_model = plan.roll_model.torque_m > 0.0F};
  if (vehicle.airframe && vehicle.airframe->roll_inertia_after_burnout_kg_m2) {
    e.plant.inertia_kg_m2 = *vehicle.airframe->roll_inertia_after_burnout_kg_m2;
  }
  if (plan.offset.rejection == core::OffsetRejection::integral) {
    e.integral_gain_per_s = factor * static_cast<double>(plan.offset.integral_gain_per_s);
  } else if (plan.offset.rejection == core::OffsetRejection::observer) {
    e.observer_bandwidth_rad_s = static_cast<double>(plan.offset.observer_bandwidth_rad_s);
  }
  if (!e.has_model || is_model_of(plan.roll_model, e.plant)) {
    const double clear_s = outlook.guide_clear ? outlook.guide_clear->time_s : opening.time_s;
    e.share = share_of(e, plan.controller, opening.time_s - clear_s);
  }
  return e;
}

std::optional<CaptureForecast> capture_forecast(const sim::Scenario& scenario, const Outlook& outlook) {
  const core::FlightPlan& plan = scenario.plan;
  if (plan.controller.entry != core::ControlEntry::capture || !outlook.opening ||
      outlook.opening->speed_m_s <= slowest_held_m_s || !stability::why_uncontrollable(scenario).empty()) {
    return std::nullopt;
  }
  const RollAtEntry e = entry_of(scenario, outlook);
  CaptureForecast all{.residual_rate_rad_s = residual_rate_rad_s(e),
                      .earliest_stop_s = earliest_stop_s(e),
                      .path_m = path_m(e),
                      .longest_path_m = longest_path_m(e),
                      .path_left_m = path_to_slow_m(e)};
  if (!scenario.faults.empty() || plan.controller.rate_reference != core::RateReference::zero) {
    all.why_not = scenario.faults.empty() ? "controller.rate_reference is not \"zero\"" : "the scenario has faults";
    return all;
  }
  all.why_not = why_no_capture_time(e);
  const auto promised = [&all, until_s = undisturbed_s(plan)](std::optional<double> within_s) {
    const bool is_disturbed = within_s && *within_s >= until_s;
    all.why_not = is_disturbed ? "the excitation begins or the reference moves too soon" : all.why_not;
    return is_disturbed ? std::nullopt : within_s;
  };
  all.within_s = promised(captured_within_s(e));
  all.from_any_angle_within_s = promised(captured_from_any_angle_within_s(e));
  return all;
}

}  // namespace fantail::dormancy
