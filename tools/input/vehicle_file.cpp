// SPDX-License-Identifier: MIT
#include "input/vehicle_file.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "input/file_checks.hpp"
#include "input/messages.hpp"
#include "input/rasp_file.hpp"
#include "input/shipped.hpp"
#include "sim/sensor_mounting.hpp"

namespace fantail::input {
namespace {

// No rocket of this kind comes near; beyond them a flight might last for days, or leave what a double can hold.
constexpr double longest_burn_s = 600.0;
constexpr double most_speed_m_s = 3000.0;

void read_motor(const Document& document, sim::Vehicle& vehicle) {
  Section motor{document, "motor"};
  // "motors.eng#K550": one of several motors in a file.
  const std::string named = motor.text("file");
  const std::size_t mark = named.rfind('#');
  const auto name = mark == std::string::npos ? std::nullopt : std::optional{named.substr(mark + 1)};
  RaspMotor read = load_rasp(motor_file(document), name);
  vehicle.motor = motors(read.curve, vehicle.motor_count, vehicle.thrust_factor);
  if (read.warning) {
    vehicle.warnings.push_back(std::move(*read.warning));
  }
  const sim::ThrustCurve& curve = vehicle.motor;
  const double empty_kg = vehicle.mass_kg - curve.propellant_kg();
  if (!(empty_kg > 0.0)) {
    Section{document, "body"}.refuse("mass_kg", "= " + plain_number(vehicle.mass_kg) +
                                                    "; allowed: more than the propellant of its motor, " +
                                                    about(curve.propellant_kg()));
  }
  if (curve.burnout_s() > longest_burn_s) {
    motor.refuse("file",
                 "burns for " + about(curve.burnout_s()) + " s; allowed: at most " + about(longest_burn_s) + " s");
  }
  if (curve.impulse_n_s() > most_speed_m_s * empty_kg) {
    motor.refuse("file", "gives " + about(curve.impulse_n_s()) + " N s to " + about(empty_kg) +
                             " kg; allowed: an impulse that gives at most " + about(most_speed_m_s) + " m/s");
  }
}

void check_reference_area(const Document& document, const sim::Vehicle& vehicle) {
  const std::vector<double>& range = vehicle.reference_area_range_m2;
  const double area_m2 = vehicle.roll_plant.reference_area_m2;
  if (!range.empty() && (range.size() != 2 || !(range[0] < area_m2 && area_m2 < range[1]))) {
    Section{document, "aerodynamics"}.refuse("reference_area_range_m2",
                                             "must be two areas, one below and one above reference_area_m2 = " +
                                                 plain_number(area_m2) + ", or [] if it is unknown");
  }
}

void check_drag(const Document& document, const sim::Vehicle& vehicle) {
  const sim::DragOverMach& drag = vehicle.drag_over_mach;
  const Section body{document, "body"};
  if (drag.mach.size() != drag.factor.size()) {
    body.refuse("drag_factor", "has " + std::to_string(drag.factor.size()) + " values and drag_mach has " +
                                   std::to_string(drag.mach.size()) + "; allowed: the same number");
  }
  for (std::size_t i = 1; i < drag.mach.size(); ++i) {
    if (!(drag.mach[i] > drag.mach[i - 1])) {
      body.refuse("drag_mach", "has " + plain_number(drag.mach[i]) + " after " + plain_number(drag.mach[i - 1]) +
                                   "; allowed: each larger than the one before");
    }
  }
}

// The canards' own part of the damping is beta times their arm.
void check_canard_arm(const Document& document, const sim::Vehicle& vehicle) {
  const auto& arm_m = vehicle.canard_air.arm_m;
  const sim::RollPlant& plant = vehicle.roll_plant;
  if (arm_m && plant.torque_m * *arm_m > plant.damping_m2) {
    Section{document, "aerodynamics"}.refuse(
        "canard_arm_m", "= " + plain_number(*arm_m) +
                            "; allowed: at most damping_m2 / torque_m = " + about(plant.damping_m2 / plant.torque_m) +
                            ", where the canards would make all of the roll damping");
  }
}

void check_side_force(const Document& document, const sim::Vehicle& vehicle) {
  const bool area = vehicle.canard_air.side_area_m2.has_value();
  if (area != vehicle.canard_air.position_m.has_value()) {
    Section{document, "aerodynamics"}.refuse(area ? "canard_side_area_m2" : "canard_position_m",
                                             area ? "needs canard_position_m" : "needs canard_side_area_m2");
  }
}

void check_servo(const Document& document, const sim::Vehicle& vehicle) {
  const Section servo{document, "servo"};
  const sim::ServoParameters& p = vehicle.servo;
  if (std::abs(p.pulse_per_degree_us) < 0.1) {
    servo.refuse("pulse_per_degree_us",
                 "= " + plain_number(p.pulse_per_degree_us) + "; allowed: at least 0.1 away from zero");
  }
  if (vehicle.servo_spread.centre_rad > p.stop_rad) {
    servo.refuse("centre_spread_deg", "= " + plain_number(deg.in_file(vehicle.servo_spread.centre_rad)) +
                                          "; allowed: at most stop_deg = " + plain_number(deg.in_file(p.stop_rad)));
  }
}

// A canard whose trim is beyond the stop of its servo never stands there.
void check_trim(const Document& document, const sim::Vehicle& vehicle) {
  const double stop_rad = vehicle.servo.stop_rad;
  for (const sim::CanardMounting& canard : vehicle.canards) {
    if (std::abs(canard.trim_rad) > stop_rad) {
      Section{document, "canard_mounting"}.refuse("trim_deg", "= " + about(deg.in_file(canard.trim_rad)) +
                                                                  " is out of range; allowed: within servo.stop_deg, " +
                                                                  about(deg.in_file(stop_rad)) + " either way");
    }
  }
}

void check_sensor(const Document& document, const char* section, const core::SensorMounting& mounting) {
  if (!sim::is_rotation(mounting)) {
    Section{document, section}.refuse("along_y", "must be another axis than to_nose");
  }
}

// Every part of a rocket lies between the tip of its nose and its tail; so then does what is made of them.
void check_airframe(const Document& document, const sim::Vehicle& vehicle) {
  if (!vehicle.airframe) {
    return;
  }
  Section section{document, "airframe"};
  const sim::Airframe& a = *vehicle.airframe;
  const std::array inside{std::pair{"centre_of_pressure_m", a.centre_of_pressure_m},
                          std::pair{"body_lift_position_m", a.body_lift_position_m},
                          std::pair{"centre_of_gravity_m", a.at_liftoff.centre_of_gravity_m},
                          std::pair{"centre_of_gravity_after_burnout_m", a.after_burnout.centre_of_gravity_m}};
  for (const auto& [key, position_m] : inside) {
    if (position_m > a.length_m) {
      section.refuse(key, "= " + plain_number(position_m) +
                              " is behind the tail; allowed: at most length_m = " + plain_number(a.length_m));
    }
  }
  if (a.parts_spread_m > a.length_m) {
    section.refuse("parts_spread_m",
                   "= " + plain_number(a.parts_spread_m) + "; allowed: at most length_m = " + plain_number(a.length_m));
  }
  if (a.diameter_m > a.length_m) {
    section.refuse("diameter_m",
                   "= " + plain_number(a.diameter_m) + "; allowed: less than length_m = " + plain_number(a.length_m));
  }
  // No body has more about one axis than about two others at right angles to it.
  const double roll_kg_m2 = vehicle.roll_plant.inertia_kg_m2;
  const std::array across{std::tuple{"transverse_inertia_kg_m2", a.at_liftoff.transverse_inertia_kg_m2, roll_kg_m2},
                          std::tuple{"transverse_inertia_after_burnout_kg_m2", a.after_burnout.transverse_inertia_kg_m2,
                                     a.roll_inertia_after_burnout_kg_m2.value_or(roll_kg_m2)}};
  for (const auto& [key, transverse_kg_m2, about_axis_kg_m2] : across) {
    if (about_axis_kg_m2 > 2.0 * transverse_kg_m2) {
      section.refuse(key, "= " + plain_number(transverse_kg_m2) +
                              "; allowed: at least half of the roll inertia then, " + plain_number(about_axis_kg_m2) +
                              ", as no body has less");
    }
  }
  if (a.body_lift_area_m2 > 0.0 && !section.has("body_lift_position_m")) {
    section.refuse("body_lift_area_m2", "needs body_lift_position_m");
  }
}

void check_place(const Document& document, const char* sensor, const sim::FeltMotionParameters& feels,
                 const sim::Airframe& airframe) {
  const Section section{document, sensor};
  if (feels.position_m && *feels.position_m > airframe.length_m) {
    section.refuse("position_m",
                   "= " + plain_number(*feels.position_m) +
                       " is behind the tail; allowed: at most airframe.length_m = " + plain_number(airframe.length_m));
  }
  const double radius_m = 0.5 * airframe.diameter_m;
  if (std::abs(feels.across_m) > radius_m) {
    section.refuse("across_m", "= " + plain_number(feels.across_m) +
                                   " is outside the body; allowed: within half of airframe.diameter_m, " +
                                   plain_number(radius_m) + " either way");
  }
}

// The shape of a rocket is known where it has an airframe.
void check_sensors(const Document& document, const sim::Vehicle& vehicle) {
  if (vehicle.airframe) {
    check_place(document, "imu", vehicle.imu_feels, *vehicle.airframe);
    check_place(document, "second_imu", vehicle.second_imu_feels, *vehicle.airframe);
    check_place(document, "accelerometer", vehicle.accelerometer_feels, *vehicle.airframe);
  }
}

}  // namespace

std::filesystem::path motor_file(const Document& document) {
  Section motor{document, "motor"};
  const std::string named = motor.text("file");
  return find_named_input(Shipped::motor, document, motor, "file", named.substr(0, named.rfind('#')));
}

sim::ThrustCurve motors(const sim::ThrustCurve& one, int count, double thrust_factor) {
  if (count == 1 && thrust_factor == 1.0) {
    return one;
  }
  std::vector<sim::ThrustPoint> points = one.points();
  for (sim::ThrustPoint& point : points) {
    point.thrust_n *= thrust_factor * count;
  }
  return {std::move(points), count * one.propellant_kg()};
}

sim::Vehicle read_vehicle(const Document& document) {
  refuse_other_kind(document, Shipped::vehicle);
  const std::vector<std::string> sections = sections_of(vehicle_fields());
  refuse_unknown_sections(document, sections);
  sim::Vehicle vehicle;
  for (const std::string& section : sections) {
    read_section(document, section, vehicle_fields(), vehicle);
  }
  read_motor(document, vehicle);
  check_reference_area(document, vehicle);
  check_drag(document, vehicle);
  check_canard_arm(document, vehicle);
  check_side_force(document, vehicle);
  check_servo(document, vehicle);
  check_trim(document, vehicle);
  check_sensor(document, "imu", vehicle.imu.mounting);
  check_sensor(document, "second_imu", vehicle.second_imu.mounting);
  check_sensor(document, "accelerometer", vehicle.accelerometer.mounting);
  check_airframe(document, vehicle);
  check_geometry(document, vehicle);
  check_sensors(document, vehicle);
  if (auto question = question_about_vehicle(document, vehicle)) {
    vehicle.warnings.push_back(std::move(*question));
  }
  return vehicle;
}

}  // namespace fantail::input
