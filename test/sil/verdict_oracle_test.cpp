// SPDX-License-Identifier: MIT
// Random rockets, faults, plans and gains: each verdict is held against the truth columns, looked at by code that
// shares nothing with the report.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "random_stream.hpp"
#include "report/verdict.hpp"
#include "seed.hpp"

namespace fantail::sil {
namespace {

using report::Outcome;

constexpr double degree = 3.14159265358979323846 / 180.0;

class Draw {
 public:
  explicit Draw(std::uint32_t seed) : stream_{seed} {}
  double between(double low, double high) { return low + (high - low) * static_cast<double>(stream_.unit()); }
  bool chance(double share) { return static_cast<double>(stream_.unit()) < share; }
  std::size_t below(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(between(0.0, static_cast<double>(count))));
  }

 private:
  core::RandomStream stream_;
};

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

void draw_fault(sim::Scenario& scenario, Draw& draw) {
  constexpr std::size_t kinds = 11;
  sim::Fault fault{.kind = static_cast<sim::FaultKind>(draw.below(kinds)),
                   .canard = draw.below(4),
                   .from_s = draw.between(0.0, 9.0),
                   .until_s = 0.0};
  fault.until_s = fault.from_s + (draw.chance(0.7) ? draw.between(0.001, 0.4) : 30.0);
  if (fault.kind == sim::FaultKind::canard_stuck || fault.kind == sim::FaultKind::canard_wrong_trim) {
    fault.angle_rad = draw.between(-2.9, 2.9) * degree;
  }
  scenario.faults.push_back(fault);
}

sim::Scenario random_launch(std::uint32_t seed) {
  static const sim::Scenario usual = input::load_scenario("tasha3_launch2", {});
  Draw draw{seed};
  sim::Scenario scenario = usual;
  scenario.seed = seed;
  draw_plan(scenario.plan, draw);
  draw_vehicle(scenario.vehicle, draw);
  const double offset_rad = draw.between(-12.0, 12.0) * degree;
  scenario.disturbance = {{.time_s = 0.0, .angle_rad = offset_rad},
                          {.time_s = 1.7, .angle_rad = offset_rad + draw.between(-2.0, 2.0) * degree}};
  for (double more = 0.5; draw.chance(more); more *= 0.5) {
    draw_fault(scenario, draw);
  }
  return scenario;
}

/// What truly was, from the rows alone.
struct Oracle {
  bool controlled = false;
  double largest_error_deg = 0.0;  ///< from the settle point, a second after control start and after each step
  bool judged = false;             ///< some row counted for it
  double turned_after_deg = 0.0;   ///< from the end of control to apogee
  double end_before_apogee_s = 0.0;
  double largest_offset_deg = 0.0;  ///< under control
};

Oracle look(const flight::Flight& flight) {
  Oracle o;
  const double kp = static_cast<double>(flight.plan.controller.proportional_gain);
  std::optional<double> zero_rad;
  std::optional<double> end_rad;
  double counts_from_s = 0.0;
  double reference_rad = 0.0;
  double end_s = 0.0;
  for (const flight::Row& row : flight.rows) {
    const bool control = row.phase == core::Phase::controlling;
    if (row.phase == core::Phase::launched && !zero_rad) {
      zero_rad = row.truth->roll_angle_rad;
    }
    if (row.phase == core::Phase::armed) {
      zero_rad.reset();  // that was no launch
    }
    if (control && (!o.controlled || row.reference_rad != reference_rad)) {
      counts_from_s = row.time_s + 1.0;
      reference_rad = row.reference_rad;
    }
    if (control) {
      o.controlled = true;
      end_rad = row.truth->roll_angle_rad;
      end_s = row.time_s;
      o.largest_offset_deg = std::max(o.largest_offset_deg, std::abs(row.truth->disturbance_rad) / degree);
      if (kp > 0.0 && row.time_s >= counts_from_s - 1e-6) {
        const double away_rad =
            row.truth->roll_angle_rad - *zero_rad - row.reference_rad - row.truth->disturbance_rad / kp;
        o.largest_error_deg = std::max(o.largest_error_deg, std::abs(away_rad) / degree);
        o.judged = true;
      }
    } else if (o.controlled && row.time_s <= flight.events.apogee_s.value_or(0.0)) {
      o.turned_after_deg = std::max(o.turned_after_deg, std::abs(row.truth->roll_angle_rad - *end_rad) / degree);
    }
  }
  o.end_before_apogee_s = flight.events.apogee_s.value_or(end_s) - end_s;
  return o;
}

int flights() {
  const char* asked = std::getenv("FANTAIL_FLIGHTS");  // NOLINT(concurrency-mt-unsafe): there is one thread
  return asked != nullptr ? std::atoi(asked) : 500;
}

TEST(VerdictOracle, NoRandomFlightIsCalledWhatItWasNot) {
  const std::uint32_t first = test::seed();
  std::map<std::string, int> outcomes;
  constexpr double rounding_deg = 0.01;
  for (int i = 0; i < flights(); ++i) {
    const std::uint32_t seed = first + static_cast<std::uint32_t>(i);
    const sim::Scenario scenario = random_launch(seed);
    const flight::Flight flight = fly::fly_scenario(scenario);
    const report::Verdict verdict = report::verdict(flight, report::figures(flight));
    const Oracle truth = look(flight);
    const std::string which = fmt::format("flight of seed {} ({}): {}", seed, i, verdict.text);
    ++outcomes[std::string{report::name(verdict.outcome)}];

    const bool planned_end =
        !flight.phase_changes.empty() && flight.phase_changes.back().reason == core::PhaseReason::control_time_over;
    const bool to_the_end = planned_end || truth.end_before_apogee_s < 0.51;
    ASSERT_EQ(verdict.outcome == Outcome::no_control, !truth.controlled) << which;
    if (verdict.outcome == Outcome::held || verdict.outcome == Outcome::oscillates) {
      EXPECT_TRUE(truth.judged && truth.largest_error_deg <= 10.0 + rounding_deg) << truth.largest_error_deg << which;
      EXPECT_TRUE(to_the_end) << truth.end_before_apogee_s << ' ' << which;
    }
    if (verdict.outcome == Outcome::cut_short) {
      EXPECT_FALSE(to_the_end) << which;
      EXPECT_LE(truth.turned_after_deg, 10.0 + rounding_deg) << which;
    }
    if (verdict.outcome == Outcome::not_judged) {
      EXPECT_FALSE(truth.judged) << which;
    }
    if (verdict.outcome == Outcome::not_held) {
      const bool spun = flight.unmeasured.spin_from_s.has_value();
      const bool left_later = !to_the_end && truth.turned_after_deg > 10.0 - rounding_deg;
      const bool overpowered = verdict.text.find("more than they can balance") != std::string::npos;
      EXPECT_TRUE(truth.largest_error_deg > 10.0 - rounding_deg || left_later || spun || overpowered) << which;
      if (overpowered) {
        const double stop_deg = std::min(scenario.vehicle.servo.stop_rad / degree,
                                         static_cast<double>(scenario.plan.controller.canard_limit.degrees()));
        EXPECT_GT(truth.largest_offset_deg, stop_deg - rounding_deg) << which;
      }
    }
  }
  for (const auto& [name, count] : outcomes) {
    fmt::print("{:5} {}\n", count, name);
  }
  EXPECT_GE(outcomes.size(), 5U) << "the draw has become one-sided";
}

}  // namespace
}  // namespace fantail::sil
