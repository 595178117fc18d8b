// SPDX-License-Identifier: MIT

#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "stability/roll_loop.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::stability {
namespace {

constexpr double speed_m_s = 81.0;

// The real avionics, servos and sensors in a steady stream of 81 m/s, all that is not in the linear loop taken away,
// with the gains of the second launch times a factor.
sim::Scenario steady_stream(double gain_factor) {
  sim::Scenario scenario = input::load_scenario("tunnel_steps", {});
  scenario.tunnel = {.fan_rpm = 2700.0, .speed_per_rpm_m_s = speed_m_s / 2700.0};
  scenario.disturbance.clear();
  scenario.vehicle.servo.backlash_rad = 0.0;
  scenario.vehicle.servo.rate_limit_rad_s = 1e4;
  scenario.plan.reference.kind = core::ReferenceKind::hold;
  scenario.plan.controller.canard_limit = core::hard_canard_limit;
  scenario.plan.controller.proportional_gain = static_cast<float>(0.5 * gain_factor);
  scenario.plan.controller.derivative_gain_s = static_cast<float>(0.05 * gain_factor);
  scenario.plan.run.control_time = core::Microseconds{12'000'000};
  return scenario;
}

/// Largest roll rate from 8 s after control start on: noise, or a loop that swings.
double late_roll_rate_deg_s(const sim::Scenario& scenario) {
  double fastest = 0.0;
  for (const flight::Row& row : fly::fly_scenario(scenario).rows) {
    if (row.time_s > 8.0 && row.phase == core::Phase::controlling) {
      fastest = std::max(fastest, std::abs(text::degrees(row.truth->roll_rate_rad_s)));
    }
  }
  return fastest;
}

// The dead time of the loop is an assumption about pulses, frames and ticks; the flown rocket knows nothing of it.
TEST(LoopAtSpeed, TheFlownRocketBeginsToSwingAtTheGainMargin) {
  const sim::Scenario usual = steady_stream(1.0);
  const auto found = margins(loop_at_speed(usual, speed_m_s));
  ASSERT_TRUE(found && found->gain_margin);
  EXPECT_LT(late_roll_rate_deg_s(steady_stream(0.93 * *found->gain_margin)), 5.0);
  EXPECT_GT(late_roll_rate_deg_s(steady_stream(1.07 * *found->gain_margin)), 30.0);
}

// Fins that take back four tenths of the torque, 12 ms later: at the frequency of the swing they hinder little.
TEST(LoopAtSpeed, TheFlownRocketWithWashOnItsFinsBeginsToSwingAtTheGainMargin) {
  const auto washed = [](double gain_factor) {
    sim::Scenario scenario = steady_stream(gain_factor);
    scenario.vehicle.canard_air.wash = 0.4;
    scenario.vehicle.canard_air.wash_distance_m = 1.0;
    return scenario;
  };
  const auto found = margins(loop_at_speed(washed(1.0), speed_m_s));
  const auto without = margins(loop_at_speed(steady_stream(1.0), speed_m_s));
  ASSERT_TRUE(found && found->gain_margin);
  EXPECT_GT(std::abs(*found->gain_margin / *without->gain_margin - 1.0), 0.1) << "the wash counts";
  EXPECT_LT(late_roll_rate_deg_s(washed(0.93 * *found->gain_margin)), 5.0);
  EXPECT_GT(late_roll_rate_deg_s(washed(1.07 * *found->gain_margin)), 30.0);
}

TEST(LoopAtSpeed, FinsThatTakeBackAllOfTheTorqueLeaveNoLoop) {
  sim::Scenario scenario = steady_stream(1.0);
  for (const double wash : {1.0, 1.5}) {
    scenario.vehicle.canard_air.wash = wash;
    EXPECT_FALSE(margins(loop_at_speed(scenario, speed_m_s))) << wash;
  }
}

TEST(LoopAtSpeed, HasTheServosOfTheVehicleAndTheGainsOfThePlan) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch1", {});
  scenario.vehicle.imu.delay_s = 0.002;
  scenario.vehicle.roll_plant.damping_m2 = 7.5;
  scenario.vehicle.roll_plant.torque_m = 10.0;
  const RollLoop loop = loop_at_speed(scenario, 97.0);
  EXPECT_EQ(loop.proportional_gain, 1.0);
  EXPECT_NEAR(loop.derivative_gain_s, 0.1, 1e-6);
  EXPECT_EQ(loop.servo_lag_s, 0.020);
  EXPECT_NEAR(loop.delay_s, 0.002 + 0.003 + 0.5 / 333.0 + 0.0005, 1e-12);
  // 1.225 kg/m3 at the launch site: rho v A alpha / (2 I) and rho v^2 A beta / (2 I).
  EXPECT_NEAR(loop.damping_rate_per_s, 1.225 * 97.0 * 5.0265e-5 * 7.5 / (2.0 * 0.00361), 1e-9);
  EXPECT_NEAR(loop.authority_per_s2, 1.225 * 97.0 * 97.0 * 5.0265e-5 * 10.0 / (2.0 * 0.00361), 1e-4);
}

TEST(LoopAtSpeed, HasTheRollInertiaAfterBurnOutWhereTheFlightFollowsThePropellant) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch1", {});
  const double at_liftoff_per_s2 = loop_at_speed(scenario, 97.0).authority_per_s2;
  scenario.vehicle.airframe = sim::Airframe{.roll_inertia_after_burnout_kg_m2 = 0.9 * 0.00361};
  scenario.motion = sim::FlightMotion::straight;
  EXPECT_EQ(loop_at_speed(scenario, 97.0).authority_per_s2, at_liftoff_per_s2);
  scenario.motion = sim::FlightMotion::six_dof;
  EXPECT_NEAR(loop_at_speed(scenario, 97.0).authority_per_s2, at_liftoff_per_s2 / 0.9, 1e-9);
}

// At 97 m/s and the sound of 15 degrees Celsius.
TEST(LoopAtSpeed, HasThePrandtlGlauertFactorOfTheVehicle) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch1", {});
  const RollLoop constant = loop_at_speed(scenario, 97.0);
  scenario.vehicle.compressibility = sim::Compressibility::prandtl_glauert;
  const RollLoop growing = loop_at_speed(scenario, 97.0);
  const double factor = 1.0 / std::sqrt(1.0 - 97.0 * 97.0 / (1.4 * 287.05287 * 288.15));
  EXPECT_NEAR(growing.damping_rate_per_s / constant.damping_rate_per_s, factor, 1e-12);
  EXPECT_NEAR(growing.authority_per_s2 / constant.authority_per_s2, factor, 1e-12);
}

// Four slow servos are servos with four times the lag; of a mixture the loop has the sum of both.
TEST(LoopAtSpeed, HasTheCanardFaultsThatAreThereAtLiftOff) {
  const auto margin_deg = [](const sim::Scenario& scenario) {
    return text::degrees(phase_margin_rad(loop_at_speed(scenario, 82.0)).value());
  };
  sim::Scenario slow = input::load_scenario("tasha3_launch2", {});
  const double healthy_deg = margin_deg(slow);
  sim::Scenario lagging = slow;
  lagging.vehicle.servo.lag_s *= 4.0;
  sim::Scenario weak = slow;
  weak.plan.controller.proportional_gain *= 0.75F;
  weak.plan.controller.derivative_gain_s *= 0.75F;
  const auto breaks = [](sim::ServoFault fault, std::size_t canard, double from_s) {
    return sim::Fault{.device = sim::Device::servo, .canard = canard, .how = sim::GearFault{fault}, .from_s = from_s};
  };
  sim::Scenario dead = slow;
  dead.faults.push_back(breaks(sim::ServoFault::dead, 2, -1.0));
  EXPECT_NEAR(margin_deg(dead), healthy_deg, 1e-3) << "the others do its part";
  dead.plan.run.canard_fault = core::CanardFaultPolicy::continue_control;
  EXPECT_NEAR(margin_deg(dead), margin_deg(weak), 1e-3) << "a quarter of the gain is gone";
  double before_deg = healthy_deg;
  for (std::size_t canard = 0; canard < 4; ++canard) {
    slow.faults.push_back(breaks(sim::ServoFault::slow, canard, 0.0));
    EXPECT_LT(margin_deg(slow), before_deg);
    before_deg = margin_deg(slow);
  }
  EXPECT_NEAR(margin_deg(slow), margin_deg(lagging), 1e-6);
  sim::Scenario later = input::load_scenario("tasha3_launch2", {});
  later.faults.push_back(breaks(sim::ServoFault::dead, 2, 3.0));
  EXPECT_EQ(margin_deg(later), healthy_deg) << "the flight says that it is not in the margins";
}

}  // namespace
}  // namespace fantail::stability
