// SPDX-License-Identifier: MIT
#include "sil/random_launch.hpp"

#include "degree.hpp"
#include "input/fault_file.hpp"
#include "input/scenario_file.hpp"
#include "sim/units.hpp"

namespace fantail::sil {
namespace {

constexpr double before_power_up_s = -1000.0;

void draw_plan(core::FlightPlan& plan, Draw& draw) {
  plan.controller.proportional_gain = draw.chance(0.1) ? 0.0F : static_cast<float>(draw.between(0.1, 3.0));
  plan.controller.derivative_gain_s = static_cast<float>(draw.between(0.0, draw.chance(0.2) ? 2.0 : 0.2));
  plan.controller.canard_limit = core::Angle::from_degrees(static_cast<float>(draw.between(2.0, 15.0)));
  plan.run.control_time = core::from_seconds(static_cast<float>(draw.between(1.0, 15.0)));
  plan.motion.longest_gyro_gap = core::from_seconds(static_cast<float>(draw.chance(0.5) ? 0.0 : 0.25));
  if (draw.chance(0.5)) {
    plan.excitation.form = core::ExcitationForm::none;
  }
  if (draw.chance(0.2)) {
    plan.run.canard_fault = core::CanardFaultPolicy::end_control;
  }
}

void draw_vehicle(sim::Vehicle& vehicle, Draw& draw) {
  vehicle.mass_kg = draw.between(1.5, 5.0);
  vehicle.roll_plant.damping_m2 = draw.between(5.0, 40.0);
  vehicle.roll_plant.torque_m = draw.between(3.0, 15.0);
  vehicle.servo.lag_s = draw.between(0.005, 0.06);
  vehicle.servo.stop_rad = draw.between(3.5, 25.0) * degree;
  vehicle.imu.full_scale_rad_s = draw.between(200.0, 2000.0) * degree;
  vehicle.imu.full_scale_m_s2 = draw.between(6.0, 16.0) * sim::gravity_m_s2;
  vehicle.accelerometer.full_scale_m_s2 = draw.between(6.0, 32.0) * sim::gravity_m_s2;
  vehicle.imu.specific_force_bias_m_s2 = draw.between(-0.4, 0.4);
  vehicle.imu.misalignment_rad = draw.between(0.0, 2.0) * degree;
}

/// Each mode of the law in a part of the plans, with a model as good as anybody's.
void draw_modes(core::FlightPlan& plan, const sim::RollPlant& plant, Draw& draw) {
  if (draw.chance(0.25)) {
    plan.gain_schedule = {
        .speeds_count = 3,
        .speeds_m_s = {20.0F, 45.0F, 80.0F},
        .factors_count = 3,
        .factors = {static_cast<float>(draw.between(0.7, 3.0)), 1.0F, static_cast<float>(draw.between(0.3, 1.5))}};
  }
  if (plan.controller.proportional_gain > 0.0F && draw.chance(0.3)) {
    plan.offset.rejection = core::OffsetRejection::integral;
    plan.offset.integral_gain_per_s = plan.controller.proportional_gain * static_cast<float>(draw.between(0.2, 3.0));
  } else if (draw.chance(0.2)) {
    plan.offset.rejection = core::OffsetRejection::observer;
    plan.offset.observer_bandwidth_rad_s = static_cast<float>(draw.between(1.0, 15.0));
    plan.roll_model = {.roll_inertia_kg_m2 = static_cast<float>(plant.inertia_kg_m2),
                       .reference_area_m2 = static_cast<float>(plant.reference_area_m2 * draw.between(0.6, 1.6)),
                       .damping_m2 = static_cast<float>(plant.damping_m2),
                       .torque_m = static_cast<float>(plant.torque_m),
                       .density_kg_m3 = 1.225F};
  }
}

}  // namespace

void draw_fault(sim::Scenario& scenario, Draw& draw) {
  constexpr std::size_t kinds = 11;
  sim::Fault fault = input::fault_kinds()[draw.below(kinds)].fault;
  fault.canard = draw.below(4);
  fault.from_s = draw.chance(0.1) ? before_power_up_s : draw.between(0.0, 9.0);
  const double until_s = fault.from_s + (draw.chance(0.7) ? draw.between(0.001, 0.4) : 30.0);
  if (fault.until_s) {
    fault.until_s = until_s;
  }
  auto* gear = std::get_if<sim::GearFault>(&fault.how);
  if (gear != nullptr && (gear->fault == sim::ServoFault::stuck || gear->fault == sim::ServoFault::wrong_trim)) {
    gear->angle_rad = draw.between(-2.9, 2.9) * degree;
  }
  scenario.faults.push_back(fault);
}

sim::Scenario random_rocket(Draw& draw) {
  static const sim::Scenario usual = input::load_scenario("tasha3_launch2", {});
  sim::Scenario scenario = usual;
  draw_plan(scenario.plan, draw);
  draw_vehicle(scenario.vehicle, draw);
  draw_modes(scenario.plan, scenario.vehicle.roll_plant, draw);
  return scenario;
}

}  // namespace fantail::sil
