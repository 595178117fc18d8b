// SPDX-License-Identifier: MIT
// What every run here takes from the print as it stands. "Ours" is read from the shipped files when the page is made.
#include <cmath>
#include <numbers>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "core/chirp.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "paper/outside_rows.hpp"
#include "paper/paper_page.hpp"
#include "sim/units.hpp"
#include "text/number.hpp"

namespace fantail::paper {
namespace {

Claim taken(std::string place, std::string what, const std::string& printed, const std::string& shipped,
            std::string why = {}) {
  return compare(InWords{.place = std::move(place),
                         .what = std::move(what),
                         .theirs = text::with_minus(printed),
                         .ours = text::with_minus(shipped),
                         .holds = printed == shipped,
                         .kind = Kind::definition,
                         .why = std::move(why)});
}

// An equation has no number to be held against; what we make of it stands beside it.
Claim equation(std::string place, std::string what, std::string printed, std::string ours, std::string why = {}) {
  return compare(InWords{.place = std::move(place),
                         .what = std::move(what),
                         .theirs = std::move(printed),
                         .ours = std::move(ours),
                         .holds = true,
                         .kind = Kind::definition,
                         .why = std::move(why)});
}

Claim vehicle(const char* file, const char* title, int mass_decimals, const char* printed) {
  const sim::Vehicle shipped =
      input::read_vehicle(input::Document::load(input::find_input(input::Shipped::vehicle, file)));
  return taken(
      "Table 1", std::string{title} + ": mass, length, diameter (section 4.1), roll inertia", printed,
      fmt::format("{:.{}f} kg, {:.2f} m, {:.0f} mm, {:.5f} kg m2", shipped.mass_kg, mass_decimals,
                  shipped.airframe->length_m, 1e3 * shipped.airframe->diameter_m, shipped.roll_plant.inertia_kg_m2));
}

// "1 and 0.1 s, limit 6 deg"
std::string law(const core::ControllerPlan& plan) {
  return fmt::format("{:g} and {:g} s, limit {:g} deg", plan.proportional_gain, plan.derivative_gain_s,
                     std::round(1e3 * static_cast<double>(plan.canard_limit.degrees())) / 1e3);
}

std::string detection(const core::FlightPlan& plan) {
  const auto& rule = plan.launch_detection;
  return fmt::format(
      "{:.1f} g over {:.1f} s, {}; guide of {:g} m, control {:g} m above it",
      static_cast<double>(rule.threshold_m_s2) / sim::gravity_m_s2, core::seconds(rule.hold),
      rule.accelerometers == core::AccelerometerRule::two_agree ? "two accelerometers" : "one accelerometer",
      plan.guide.length_m, plan.guide.clearance_m);
}

void add_equations(std::vector<Claim>& claims) {
  claims.push_back(equation("Eq 1 to 3", "Roll: inertia, damping, torque and disturbance",
                            "I dp/dt = 1/2 \u03c1 v\u00b2 A \u03b2 (u + u_dist) \u2212 1/2 \u03c1 v A \u03b1 p",
                            "the roll plant of every run here, stepped exactly"));
  claims.push_back(equation("Eq 4 to 8", "Disturbance", "straight lines between times T0 to TN", "the same"));
  claims.push_back(equation("Eq 9 to 12", "Open loop from encoders, closed loop from the controller; square wave",
                            "u_fin, R(t)", "the same; the rate reference is zero, see the slip of Eq 10"));
  claims.push_back(equation("Eq 13 to 23", "Identification: a grid, and least squares in each cell",
                            "lsqnonlin of Matlab", "the same minimum, open loop by one linear solve",
                            "With damping and torque constant fixed, the angle is linear in the offsets."));
  claims.push_back(equation("Eq 26", "Turbulence", "\u0393 = \u03c3\u00b2 / mean", "the same, and \u03c3 / mean"));
  claims.push_back(equation("Eq 27", "Equivalent fin offset", "\u03b1 p / (\u03b2 v)", "the same"));
  claims.push_back(equation("Eq 32 and 33", "Command and canard angle", "mean of four", "the same"));
  claims.push_back(equation("Eq 34", "Grid", "\u03b1 1 to 60, \u03b2 5 to 15", "\u03b1 by 1, \u03b2 by 0.5",
                            "Two slips of its print have rows of their own."));
}

void add_excitation(std::vector<Claim>& claims, const core::ExcitationPlan& plan) {
  claims.push_back(taken("Section 4.3.2, eq 46", "Excitation: amplitude; on from, and until 5 s after the step at 2 s",
                         "4 deg, 0.4 to 7 s after control start",
                         fmt::format("{:g} deg, {:g} to {:g} s after control start",
                                     std::round(1e3 * static_cast<double>(plan.amplitude.degrees())) / 1e3,
                                     core::seconds(plan.begin), core::seconds(plan.end))));
  auto flown_deg = [chirp = core::Chirp{plan}](int ms) mutable {
    return static_cast<double>(chirp.update(core::Microseconds{1000 * ms}).degrees());
  };
  double furthest_deg = 0.0;
  for (int ms = 400; ms < 7000; ++ms) {
    const double t = 1e-3 * ms;
    const double by_eq_45_deg = 4.0 * std::sin(2.0 * std::numbers::pi * (2.0 * t - 10.0) * t);
    furthest_deg = std::max(furthest_deg, std::abs(flown_deg(ms) - by_eq_45_deg));
  }
  claims.push_back(compare(InWords{
      .place = "Eq 45 and 46, figure 26",
      .what = "Form of the excitation",
      .theirs = "(A0 + \u0394A) sin((\u03c90 + \u0394\u03c9) t), \u03c90 = 2\u03c0 (2t 10)",
      .ours =
          fmt::format("4 deg sin(2\u03c0 (2t \u2212 10) t); the flight code is within {:.6f} deg of it", furthest_deg),
      .holds = furthest_deg < 1e-3,
      .kind = Kind::definition,
      .why = "Our text of the publication has no operator between 2t and 10; 2t \u2212 10 is taken. \u03c90 multiplies "
             "t, so the frequency is |4t \u2212 10| Hz. It is 8.4 at 0.4 s, zero at 2.5 s, 18 at 7 s. Were \u03c90 "
             "itself the frequency, it would be |2t \u2212 10| Hz, zero at 5 s."}));
  claims.push_back(unpublished("Eq 46", "Random variations \u0394A and \u0394\u03c9 of the excitation", "not given",
                               "Neither their size nor their course is printed; the runs here are without."));
}

}  // namespace

Chapter inputs_chapter() {
  Chapter chapter{.title = "Taken as printed, or outside the model",
                  .introduction = "Equations and inputs; \u201cOurs\u201d is read from the shipped files."};
  auto& claims = chapter.claims;
  claims.push_back(vehicle("smokey", "Smokey", 1, "3.0 kg, 1.52 m, 80 mm, 0.00311 kg m2"));
  claims.push_back(vehicle("tasha3_launch1", "Tasha III, launch 1", 2, "3.47 kg, 1.51 m, 80 mm, 0.00361 kg m2"));
  claims.push_back(vehicle("tasha3_launch2", "Tasha III, launch 2", 2, "3.99 kg, 1.51 m, 80 mm, 0.00393 kg m2"));
  add_equations(claims);

  const sim::Scenario flow = input::load_scenario("tunnel_flow", {});
  std::vector<double> fan_rpm;
  fan_rpm.reserve(flow.fan_programme.size());
  for (const sim::FanSetPoint& point : flow.fan_programme) {
    fan_rpm.push_back(point.fan_rpm);
  }
  claims.push_back(taken("Eq 24", "Fan speeds, rpm", "570, 870, 1100, 1400, 1650, 1700",
                         fmt::format("{}", fmt::join(fan_rpm, ", "))));
  claims.push_back(taken("Section 4.1.1", "Wind sensor: a reading every, rounded to", "2 s, 0.1 m/s",
                         fmt::format("{:g} s, {:g} m/s", flow.wind_sensor.period_s, flow.wind_sensor.resolution_m_s)));

  const core::FlightPlan first = input::load_scenario("tasha3_launch1", {}).plan;
  const core::FlightPlan steps = input::load_scenario("tunnel_steps", {}).plan;
  const core::FlightPlan second = input::load_scenario("tasha3_launch2", {}).plan;
  const auto angle = [](core::Angle a) { return std::round(1e3 * static_cast<double>(a.degrees())) / 1e3; };
  claims.push_back(taken("Section 4.2, eq 28 to 31", "Launch 1: gains and limit", "1 and 0.1 s, limit 6 deg",
                         law(first.controller)));
  claims.push_back(taken(
      "Section 4.2, eq 30", "Launch 1: reference, then alternating every second", "0 deg, -15 and 15 deg after 1 s",
      fmt::format("{:g} deg, {:g} and {:g} deg after {:g} s", angle(first.reference.initial),
                  angle(first.reference.square_wave_first), angle(first.reference.square_wave_second),
                  core::seconds(first.reference.square_wave_begin)),
      "One step of it is in the analysed data, and in ours."));
  claims.push_back(taken("Section 4.2", "Launch 1: detection and control start",
                         "2.0 g over 0.2 s, one accelerometer; guide of 4 m, control 2 m above it", detection(first)));
  claims.push_back(
      taken("Section 4.3.1, eq 43", "Tunnel: gains, reference", "0.5 and 0.05 s; 45 and 0 deg, 0.1 Hz",
            fmt::format("{:g} and {:g} s; {:g} and {:g} deg, {:g} Hz", steps.controller.proportional_gain,
                        steps.controller.derivative_gain_s, angle(steps.reference.square_wave_first),
                        angle(steps.reference.square_wave_second), steps.reference.square_wave_frequency_hz)));
  claims.push_back(
      equation("Section 4.3.1, eq 44", "Tunnel: times of the disturbance", "T0 = 0, T1 = 5 s, N = 1", "the same"));
  claims.push_back(taken("Section 4.3.2", "Launch 2: limit, and the step 2 s after control start",
                         "9 deg, 0 to -20 deg",
                         fmt::format("{:g} deg, {:g} to {:g} deg", angle(second.controller.canard_limit),
                                     angle(second.reference.initial), angle(second.reference.step_angles[0])),
                         "Its gains are not printed."));
  claims.push_back(taken("Section 4.3.2", "Launch 2: detection and control start",
                         "2.5 g over 0.1 s, two accelerometers; guide of 4 m, control 2 m above it", detection(second),
                         "How the two accelerometers are combined is not printed. Ours must agree behind a low-pass "
                         "filter, and control has a least speed; both are our own."));
  add_excitation(claims, second.excitation);
  for (const OutsideRow& row : outside_rows) {
    claims.push_back({.place = row.place, .what = row.what, .theirs = row.printed, .kind = row.kind, .why = row.why});
  }
  return chapter;
}

}  // namespace fantail::paper
