// SPDX-License-Identifier: MIT
#include "sil/any_rocket.hpp"

#include "core/flight_plan_members.hpp"
#include "degree.hpp"
#include "input/scenario_file.hpp"
#include "sim/units.hpp"

namespace fantail::sil {
namespace {

float real(double value) { return static_cast<float>(value); }
core::Angle angle(double degrees) { return core::Angle::from_degrees(real(degrees)); }
core::Microseconds time(double seconds) { return core::from_seconds(real(seconds)); }

/// Each order of magnitude as often as the others.
double evenly_in_size(Draw& draw, double low, double high) {
  return low * std::pow(high / low, draw.between(0.0, 1.0));
}

/// Two lines up and down about a mean thrust, as motors burn that are progressive or regressive.
sim::ThrustCurve draw_motor(double mass_kg, Draw& draw) {
  const double burn_s = evenly_in_size(draw, 0.3, 4.5);
  const double thrust_n = mass_kg * sim::gravity_m_s2 * draw.between(5.0, 18.0);
  const double tilt = draw.between(-0.4, 0.4);
  const double propellant_kg = std::min(0.5 * mass_kg, thrust_n * burn_s / 2000.0);
  return {{{0.0, 0.0}, {0.03, thrust_n * (1.0 - tilt)}, {burn_s, thrust_n * (1.0 + tilt)}, {burn_s + 0.05, 0.0}},
          propellant_kg};
}

void draw_body(sim::Vehicle& vehicle, Draw& draw) {
  vehicle.mass_kg = evenly_in_size(draw, 0.8, 20.0);
  vehicle.motor = draw_motor(vehicle.mass_kg, draw);
  const double diameter_m = 0.05 * std::cbrt(vehicle.mass_kg) * draw.between(0.7, 1.3);
  const double cross_section_m2 = 0.25 * std::numbers::pi * diameter_m * diameter_m;
  vehicle.drag_area_m2 = cross_section_m2 * draw.between(0.25, 0.9);
  vehicle.roll_plant = {.inertia_kg_m2 = 0.125 * vehicle.mass_kg * diameter_m * diameter_m * draw.between(0.6, 1.6),
                        .reference_area_m2 = cross_section_m2 * evenly_in_size(draw, 0.003, 0.1),
                        .damping_m2 = draw.between(4.0, 50.0),
                        .torque_m = draw.between(1.5, 20.0)};
  vehicle.servo.lag_s = draw.between(0.005, 0.06);
  vehicle.servo.stop_rad = draw.between(4.0, 25.0) * degree;
  vehicle.canard_air.wash = draw.chance(0.1) ? draw.between(0.0, 0.9) : 0.0;
  vehicle.canard_air.wash_distance_m = 0.6;
  vehicle.airframe.reset();
}

void draw_law(core::FlightPlan& plan, const sim::RollPlant& plant, Draw& draw) {
  const bool is_weak = draw.chance(0.2);
  plan.controller.proportional_gain = real(is_weak ? evenly_in_size(draw, 0.01, 0.3) : draw.between(0.2, 3.0));
  plan.controller.derivative_gain_s = real(draw.chance(0.25) ? 0.0 : draw.between(0.0, 0.2));
  plan.controller.canard_limit = angle(draw.between(3.0, 18.0));
  plan.offset.rejection = core::OffsetRejection::none;
  plan.gain_schedule = {};
  if (draw.chance(0.2)) {
    plan.offset.rejection = core::OffsetRejection::integral;
    plan.offset.integral_gain_per_s = plan.controller.proportional_gain * real(draw.between(0.2, 2.0));
  } else if (draw.chance(0.1)) {
    plan.offset.rejection = core::OffsetRejection::observer;
    plan.offset.observer_bandwidth_rad_s = real(draw.between(1.0, 10.0));
    plan.roll_model = {.roll_inertia_kg_m2 = real(plant.inertia_kg_m2),
                       .reference_area_m2 = real(plant.reference_area_m2 * draw.between(0.7, 1.4)),
                       .damping_m2 = real(plant.damping_m2),
                       .torque_m = real(plant.torque_m),
                       .density_kg_m3 = 1.225F};
  }
  if (draw.chance(0.2)) {
    const double slow_m_s = draw.between(15.0, 40.0);
    plan.gain_schedule = {.speeds_count = 2,
                          .speeds_m_s = {real(slow_m_s), real(slow_m_s * draw.between(2.0, 8.0))},
                          .factors_count = 2,
                          .factors = {real(draw.between(0.5, 3.0)), real(draw.between(0.05, 1.5))}};
  }
}

void draw_programme(core::FlightPlan& plan, Draw& draw) {
  plan.run.control_time = time(draw.chance(0.4) ? 60.0 : evenly_in_size(draw, 0.5, 60.0));
  plan.excitation.form = draw.chance(0.2) ? core::ExcitationForm::product : core::ExcitationForm::none;
  core::ReferencePlan& reference = plan.reference;
  reference.initial = angle(draw.chance(0.5) ? 0.0 : draw.between(-90.0, 90.0));
  reference.kind = core::ReferenceKind::hold;
  if (draw.chance(0.3)) {
    reference.kind = core::ReferenceKind::steps;
    reference.step_times_count = reference.step_angles_count = 2;
    reference.step_times = {time(draw.between(0.5, 3.0)), time(draw.between(3.5, 9.0))};
    reference.step_angles = {angle(draw.between(-180.0, 180.0)), angle(draw.between(-180.0, 180.0))};
  } else if (draw.chance(0.15)) {
    reference.kind = core::ReferenceKind::square_wave;
    reference.square_wave_begin = time(draw.between(0.0, 2.0));
    reference.square_wave_first = angle(draw.between(-90.0, 90.0));
    reference.square_wave_second = angle(draw.between(-90.0, 90.0));
    reference.square_wave_frequency_hz = real(evenly_in_size(draw, 0.05, 1.0));
  }
}

/// One angle, or one that wanders while the rocket flies.
void draw_offset(sim::Scenario& scenario, Draw& draw) {
  const double most_deg = draw.chance(0.6) ? 2.0 : 14.0;
  double angle_deg = draw.between(-most_deg, most_deg);
  scenario.disturbance = {{.time_s = 0.0, .angle_rad = angle_deg * degree}};
  for (double time_s = draw.between(0.5, 3.0); draw.chance(0.3); time_s += draw.between(0.5, 5.0)) {
    angle_deg += draw.between(-3.0, 3.0);
    scenario.disturbance.push_back({.time_s = time_s, .angle_rad = angle_deg * degree});
  }
}

}  // namespace

sim::Scenario any_rocket(Draw& draw) {
  static const sim::Scenario usual = input::load_scenario("tasha3_launch2", {});
  sim::Scenario scenario = usual;
  core::FlightPlan& plan = scenario.plan;
  draw_body(scenario.vehicle, draw);
  do {
    draw_law(plan, scenario.vehicle.roll_plant, draw);
    draw_programme(plan, draw);
    plan.guide.length_m = real(draw.between(1.5, 8.0));
    plan.guide.minimum_speed_m_s = real(draw.between(8.0, 20.0));
  } while (core::validate(plan));
  draw_offset(scenario, draw);
  scenario.atmosphere.model = draw.chance(0.5) ? sim::DensityModel::isa : sim::DensityModel::exponential;
  scenario.atmosphere.elevation_m = draw.between(0.0, 2000.0);
  scenario.rest_limit_rad = (draw.chance(0.6) ? 10.0 : evenly_in_size(draw, 1.0, 90.0)) * degree;
  if (draw.chance(0.1)) {
    draw_fault(scenario, draw);
  }
  return scenario;
}

}  // namespace fantail::sil
