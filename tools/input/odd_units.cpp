// SPDX-License-Identifier: MIT
// Factors of a thousand in a motor file.
#include <numbers>
#include <string>

#include "input/messages.hpp"
#include "input/rasp_file.hpp"

namespace fantail::input {

std::string odd_units(const RaspMotor& motor) {
  constexpr double slowest_m_s = 100.0;  // of an exhaust; black powder has 800, composites have 2000
  constexpr double fastest_m_s = 5000.0;
  constexpr double densest_kg_m3 = 3000.0;
  const double propellant_kg = motor.curve.propellant_kg();
  const double exhaust_m_s = motor.curve.impulse_n_s() / propellant_kg;
  if (exhaust_m_s < slowest_m_s || exhaust_m_s > fastest_m_s) {
    return "its propellant of " + plain_number(propellant_kg) + " kg gives " + about(exhaust_m_s) +
           " N s a kilogram, and motors give " + plain_number(slowest_m_s) + " to " + plain_number(fastest_m_s) +
           ": are its masses in another unit than kilograms, or its thrust in another than newtons?";
  }
  const double case_m3 = 0.25 * std::numbers::pi * motor.diameter_m * motor.diameter_m * motor.length_m;
  if (case_m3 > 0.0 && propellant_kg > densest_kg_m3 * case_m3) {
    return "its propellant of " + plain_number(propellant_kg) + " kg does not fit into a case of " +
           plain_number(1000.0 * motor.diameter_m) + " mm by " + plain_number(1000.0 * motor.length_m) +
           " mm: are its sizes in another unit than millimetres?";
  }
  return {};
}

}  // namespace fantail::input
