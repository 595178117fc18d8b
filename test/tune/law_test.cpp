// SPDX-License-Identifier: MIT
#include "tune/law.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "input/scenario_file.hpp"
#include "text/error.hpp"

namespace fantail::tune {
namespace {

using core::OffsetRejection;

TEST(Law, OfAScheduleHasFactorsThatFallWithThePowerOfTheSpeed) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const Law law{.gains = {0.5, 0.05}, .integral_gain_per_s = 0.3, .schedule_exponent = 1.5};
  const core::FlightPlan plan = with_law(scenario, OffsetRejection::integral, law, {20.0, 80.0});
  ASSERT_EQ(plan.gain_schedule.speeds_count, 6);
  EXPECT_EQ(plan.gain_schedule.speeds_m_s[0], 20.0F);
  EXPECT_EQ(plan.gain_schedule.speeds_m_s[5], 80.0F);
  EXPECT_NEAR(plan.gain_schedule.factors[0], 8.0, 1e-6);
  EXPECT_EQ(plan.gain_schedule.factors[5], 1.0F);
  EXPECT_EQ(plan.offset.integral_gain_per_s, 0.3F);
  EXPECT_EQ(with_law(scenario, OffsetRejection::integral, law, {22.0, 22.1}).gain_schedule.speeds_count, 0);
}

TEST(Law, AnObserverGetsTheRollModelOfTheVehicle) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const core::FlightPlan plan = with_law(scenario, OffsetRejection::observer,
                                         {.gains = {0.5, 0.05}, .observer_bandwidth_rad_s = 3.0}, {20.0, 80.0});
  EXPECT_EQ(plan.roll_model.damping_m2, 23.0F);
  EXPECT_EQ(plan.roll_model.torque_m, 9.0F);
  EXPECT_NEAR(plan.roll_model.density_kg_m3, 1.225, 1e-3);
}

TEST(Law, AnObserverGetsTheRollInertiaAfterBurnOut) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const auto inertia_kg_m2 = [&] {
    return with_law(scenario, OffsetRejection::observer, {.gains = {0.5, 0.05}, .observer_bandwidth_rad_s = 3.0},
                    {20.0, 80.0})
        .roll_model.roll_inertia_kg_m2;
  };
  EXPECT_EQ(inertia_kg_m2(), 0.00393F);  // as at lift-off: the vehicle says nothing else
  scenario.vehicle.airframe = sim::Airframe{.roll_inertia_after_burnout_kg_m2 = 0.0035};
  EXPECT_EQ(inertia_kg_m2(), 0.0035F);
}

TEST(Law, WithoutAKnownSpeedThereIsNoObserver) {
  const sim::Scenario scenario = input::load_scenario("tunnel_steps", {});
  EXPECT_THROW((void)with_law(scenario, OffsetRejection::observer,
                              {.gains = {0.5, 0.05}, .observer_bandwidth_rad_s = 3.0}, {22.0, 22.0}),
               text::Error);
}

// From 12 m/s to 144 m/s the square of the ratio is 144, and a plan allows 100; from 14.4 m/s on it is 100.
TEST(Law, ASteepScheduleThatNoPlanAllowsIsLeftOutWithTheSpeedThatWouldAllowIt) {
  const stability::SpeedRange wide{12.0, 144.0};
  EXPECT_TRUE(is_within_plan(1.5, wide));  // 41.6
  EXPECT_FALSE(is_within_plan(2.0, wide));
  const std::string said = schedules_left_out(wide);
  EXPECT_NE(said.find("to the power of 2. They need a factor of up to 144 at 12.0 m/s, and a plan allows at most 100"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("begins at 14.4 m/s or faster"), std::string::npos) << said;
  EXPECT_EQ(schedules_left_out({14.4, 144.0}), "");
  EXPECT_EQ(schedules_left_out({14.4, 14.5}), "");
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  for (const double exponent : schedule_exponents) {
    const Law law{.gains = {0.5, 0.05}, .schedule_exponent = exponent};
    EXPECT_NO_THROW((void)with_law(scenario, OffsetRejection::none, law, {14.4, 144.0})) << exponent;
  }
}

}  // namespace
}  // namespace fantail::tune
