// SPDX-License-Identifier: MIT
#include "sim/vehicle.hpp"

#include <algorithm>
#include <cmath>

#include "sim/document.hpp"
#include "sim/input_error.hpp"
#include "sim/rasp_file.hpp"
#include "sim/shipped.hpp"
#include "sim/shown.hpp"
#include "sim/units.hpp"

namespace fantail::sim {
namespace {

constexpr std::size_t most_assumptions = 100;

void read_body(const Document& document, Vehicle& vehicle) {
  Section body{document, "body"};
  vehicle.name = body.text("name");
  vehicle.assumed = body.texts("assumed", most_assumptions);
  vehicle.mass_kg = body.number("mass_kg", {0.1, 1000});
  vehicle.drag_area_m2 = body.number("drag_area_m2", {0, 1});
  vehicle.roll_plant.inertia_kg_m2 = body.number("roll_inertia_kg_m2", {1e-6, 10});
  body.finish();

  Section aerodynamics{document, "aerodynamics"};
  vehicle.roll_plant.reference_area_m2 = aerodynamics.number("reference_area_m2", {1e-8, 1});
  vehicle.roll_plant.damping_m2 = aerodynamics.number("damping_m2", {0, 1e4});
  vehicle.roll_plant.torque_m = aerodynamics.number("torque_m", {0, 1e4});
  aerodynamics.finish();
}

// No rocket of this kind comes near; beyond them a flight might last for days, or leave what a double can hold.
constexpr double longest_burn_s = 600.0;
constexpr double most_speed_m_s = 3000.0;

void read_motor(const Document& document, Vehicle& vehicle) {
  Section motor{document, "motor"};
  vehicle.motor = load_rasp(find_named_input(Shipped::motor, document, motor, "file"));
  const ThrustCurve& curve = vehicle.motor;
  const double empty_kg = vehicle.mass_kg - curve.propellant_kg();
  if (!(empty_kg > 0.0)) {
    Section{document, "body"}.refuse("mass_kg", "= " + shown(vehicle.mass_kg) +
                                                    "; allowed: more than the propellant of its motor, " +
                                                    about(curve.propellant_kg()));
  }
  if (curve.burnout_s() > longest_burn_s) {
    motor.refuse("file",
                 "burns for " + about(curve.burnout_s()) + " s; allowed: at most " + about(longest_burn_s) + " s");
  }
  if (curve.impulse_n_s() > most_speed_m_s * empty_kg) {
    motor.refuse("file", "gives " + about(curve.impulse_n_s()) + " N s to " + about(empty_kg) +
                             " kg; allowed: what makes at most " + about(most_speed_m_s) + " m/s");
  }
  motor.finish();
}

void read_servo(const Document& document, Vehicle& vehicle) {
  Section servo{document, "servo"};
  ServoParameters& p = vehicle.servo;
  p.lag_s = servo.number("lag_s", {0.0005, 1}, p.lag_s);
  p.delay_s = servo.number("delay_s", {0, 0.05}, p.delay_s);
  p.frame_period_s = 1.0 / servo.number("frame_rate_hz", {40, 1000}, 1.0 / p.frame_period_s);
  p.rate_limit_rad_s =
      radians_per_degree * servo.number("rate_limit_deg_s", {1, 1e5}, p.rate_limit_rad_s / radians_per_degree);
  p.stop_rad = radians_per_degree * servo.number("stop_deg", {1, 90}, p.stop_rad / radians_per_degree);
  p.backlash_rad = radians_per_degree * servo.number("backlash_deg", {0, 5}, p.backlash_rad / radians_per_degree);
  p.pulse_centre_us = servo.number("pulse_centre_us", {500, 2500}, p.pulse_centre_us);
  p.pulse_per_degree_us = servo.number("pulse_per_degree_us", {-40, 40}, p.pulse_per_degree_us);
  if (std::abs(p.pulse_per_degree_us) < 0.1) {
    servo.refuse("pulse_per_degree_us", "= " + shown(p.pulse_per_degree_us) + "; allowed: at least 0.1 away from zero");
  }
  vehicle.servo_spread = {.share = servo.number("spread", {0, 0.3}, 0.0),
                          .centre_rad = radians_per_degree * servo.number("centre_spread_deg", {0, 2}, 0.0)};
  if (vehicle.servo_spread.centre_rad > p.stop_rad) {
    servo.refuse("centre_spread_deg", "= " + shown(vehicle.servo_spread.centre_rad / radians_per_degree) +
                                          "; allowed: at most stop_deg = " + shown(p.stop_rad / radians_per_degree));
  }
  servo.finish();
}

// Four values, or the same for all; absent means zero.
std::array<double, 4> four(Section& section, std::string_view key, Limits limits) {
  const std::vector<double> values = section.numbers(key, limits, 4);
  if (!values.empty() && values.size() != 4) {
    section.refuse(key, "has " + std::to_string(values.size()) + " values; allowed: four");
  }
  std::array<double, 4> result{};
  std::ranges::copy(values, result.begin());
  return result;
}

void read_canards(const Document& document, Vehicle& vehicle) {
  Section canards{document, "canard_mounting"};
  const auto trims = four(canards, "trim_deg", {-5, 5});
  const auto zeros = four(canards, "encoder_zero_deg", {-180, 180});
  constexpr std::array<std::string_view, 2> words{"normal", "reversed"};
  const std::vector<std::size_t> directions = canards.choices("direction", words, 4);
  if (!directions.empty() && directions.size() != 4) {
    canards.refuse("direction", "has " + std::to_string(directions.size()) + " values; allowed: four");
  }
  for (std::size_t i = 0; i < vehicle.canards.size(); ++i) {
    vehicle.canards[i] = {.reversed = !directions.empty() && directions[i] == 1,
                          .trim_rad = radians_per_degree * trims[i],
                          .encoder_zero_rad = radians_per_degree * zeros[i]};
  }
  canards.finish();
}

// Both inertial sensors are described by the same words; the second one has no gyro.
void read_inertial(const Document& document, const std::string& name, bool gyro, InertialParameters& p) {
  Section section{document, name};
  if (gyro) {
    p.rate_noise_rad_s =
        radians_per_degree * section.number("rate_noise_deg_s", {0, 100}, p.rate_noise_rad_s / radians_per_degree);
    p.rate_bias_rad_s =
        radians_per_degree * section.number("rate_bias_deg_s", {-50, 50}, p.rate_bias_rad_s / radians_per_degree);
    p.full_scale_rad_s =
        radians_per_degree * section.number("full_scale_deg_s", {50, 4000}, p.full_scale_rad_s / radians_per_degree);
  }
  p.specific_force_noise_m_s2 = section.number("specific_force_noise_m_s2", {0, 50}, p.specific_force_noise_m_s2);
  p.specific_force_bias_m_s2 = section.number("specific_force_bias_m_s2", {-5, 5}, p.specific_force_bias_m_s2);
  p.full_scale_m_s2 = gravity_m_s2 * section.number("full_scale_g", {2, 400}, p.full_scale_m_s2 / gravity_m_s2);
  p.misalignment_rad =
      radians_per_degree * section.number("misalignment_deg", {0, 10}, p.misalignment_rad / radians_per_degree);
  p.delay_s = section.number("delay_s", {0, 0.02}, p.delay_s);
  section.finish();
}

void read_tolerances(const Document& document, CanardTolerances& t) {
  Section section{document, "canard_tolerances"};
  const auto degrees = [&section](std::string_view key, Limits limits, double& value_rad) {
    value_rad = radians_per_degree * section.number(key, limits, value_rad / radians_per_degree);
  };
  constexpr Limits of_an_angle{0.05, 10};
  degrees("reach_deg", of_an_angle, t.reach_rad);
  degrees("tracking_deg", of_an_angle, t.tracking_rad);
  degrees("centring_deg", of_an_angle, t.centring_rad);
  degrees("backlash_deg", of_an_angle, t.backlash_rad);
  degrees("slowest_slew_deg_s", {1, 1e5}, t.slowest_slew_rad_s);
  t.longest_step_time_s = section.number("longest_step_time_s", {0.001, 5}, t.longest_step_time_s);
  degrees("noise_deg", {0.01, 10}, t.noise_rad);
  t.dropout_share = 0.01 * section.number("dropout_percent", {0, 50}, 100.0 * t.dropout_share);
  section.finish();
}

}  // namespace

std::vector<std::string> vehicle_sections() {
  return {"body",    "aerodynamics",     "motor", "servo", "canard_mounting", "imu", "accelerometer",
          "encoder", "canard_tolerances"};
}

Vehicle read_vehicle(const Document& document) {
  refuse_unknown_sections(document, vehicle_sections());
  Vehicle vehicle;
  vehicle.accelerometer.full_scale_m_s2 = 32.0 * gravity_m_s2;
  read_body(document, vehicle);
  read_motor(document, vehicle);
  read_servo(document, vehicle);
  read_canards(document, vehicle);
  read_inertial(document, "imu", true, vehicle.imu);
  read_inertial(document, "accelerometer", false, vehicle.accelerometer);
  Section encoder{document, "encoder"};
  vehicle.encoder = {.noise_counts = encoder.number("noise_counts", {0, 1000}, vehicle.encoder.noise_counts),
                     .resolution_bits = static_cast<int>(
                         encoder.integer("resolution_bits", {4, 14}, vehicle.encoder.resolution_bits))};
  encoder.finish();
  read_tolerances(document, vehicle.canard_tolerances);
  return vehicle;
}

}  // namespace fantail::sim
