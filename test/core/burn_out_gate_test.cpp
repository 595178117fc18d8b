// SPDX-License-Identifier: MIT
#include "core/dormancy_gate.hpp"
#include "gated_ascent.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

/// How long an 8 Hz low-pass takes from one level past another, on its way to a third.
double lag_s(double from, double past, double to) {
  return std::log((from - to) / (past - to)) / (2.0 * std::numbers::pi * 8.0);
}

TEST(BurnOutGate, OpensATenthOfASecondAfterTheLowPassedThrustIsOver) {
  GatedAscent ascent{until(DormantUntil::burn_out)};
  EXPECT_FALSE(ascent.reads(5.0, ms(2'000)));
  EXPECT_NEAR(ascent.changes_after(-0.5), lag_s(5.0, 0.15, -0.5) + 0.1, 0.002);
}

TEST(BurnOutGate, DoesNotBelieveAThrustThatIsOverBeforeTheClock) {
  GatedAscent ascent{until(DormantUntil::burn_out)};
  ascent.reads(5.0, ms(500));
  EXPECT_NEAR(0.5 + ascent.changes_after(-0.5), 1.1, 0.0011);  // the factor times the burn time
}

TEST(BurnOutGate, TheClockRunsFromFirstThrustAndHasTheFactorOfThePlan) {
  DormancyPlan plan = until(DormantUntil::burn_out);
  plan.burn_clock_factor = 1.5F;
  GatedAscent ascent{plan};
  ascent.motion.thrust_since = ms(250);
  EXPECT_NEAR(ascent.changes_after(-0.5), 0.25 + 1.5, 0.0011);
}

TEST(BurnOutGate, NeverOpensByTimeAlone) {
  GatedAscent pushed{until(DormantUntil::burn_out)};
  EXPECT_FALSE(pushed.reads(0.16, ms(120'000)));
  GatedAscent carried{until(DormantUntil::burn_out)};
  carried.motion.speed_m_s = 15.0F;
  EXPECT_FALSE(carried.reads(-1.0, ms(120'000)));
  carried.motion.speed_m_s = 15.1F;
  EXPECT_TRUE(carried.reads(-1.0, ms(1)));
}

TEST(BurnOutGate, AnAccelerometerThatReadsATenthOfAGTooMuchDoesNotHideIt) {
  GatedAscent ascent{until(DormantUntil::burn_out)};
  ascent.reads(5.1, ms(2'000));
  EXPECT_NEAR(ascent.changes_after(0.1), lag_s(5.1, 0.15, 0.1) + 0.1, 0.002);
}

TEST(BurnOutGate, APauseThatEndsInThrustIsTakenOffTheClock) {
  GatedAscent ascent{until(DormantUntil::burn_out)};
  ascent.reads(5.0, ms(300));
  EXPECT_FALSE(ascent.reads(-0.5, ms(600)));
  EXPECT_FALSE(ascent.reads(5.0, ms(400)));
  // It began when the low-pass fell below 0.15 g, and ended when it rose above 1 g.
  const double pause_s = 0.6 - lag_s(5.0, 0.15, -0.5) + lag_s(-0.5, 1.0, 5.0);
  EXPECT_NEAR(1.3 + ascent.changes_after(-0.5), 1.1 + pause_s, 0.003);
}

TEST(BurnOutGate, ThrustAgainForATenthOfASecondClosesIt) {
  for (const int length_ms : {60, 140}) {
    GatedAscent ascent{until(DormantUntil::burn_out)};
    ascent.reads(5.0, ms(1'000));
    ASSERT_TRUE(ascent.reads(-0.5, ms(1'000)));
    ascent.reads(5.0, ms(length_ms));
    EXPECT_TRUE(length_ms < 100 ? ascent.reads(-0.5, ms(1)) : !ascent.reads(5.0, ms(1)));
  }
  GatedAscent ascent{until(DormantUntil::burn_out)};
  ascent.reads(5.0, ms(1'000));
  ASSERT_TRUE(ascent.reads(-0.5, ms(1'000)));
  EXPECT_TRUE(ascent.reads(0.99, ms(5'000))) << "what pushes less than 1 g closes nothing";
  EXPECT_NEAR(ascent.changes_after(3.0), lag_s(0.99, 1.0, 3.0) + 0.1, 0.002);
}

TEST(BurnOutGate, AHoldBeginsAnewWhereNothingWasMeasured) {
  for (const SensorState state : {SensorState::lost, SensorState::failed, SensorState::coasting}) {
    GatedAscent ascent{until(DormantUntil::burn_out)};
    ascent.reads(5.0, ms(2'000));
    ascent.reads(-0.5, ms(120));
    ascent.motion.accelerometer = state;
    ascent.tick();
    ascent.motion.accelerometer = SensorState::fresh;
    const double left_s = lag_s(5.0, 0.15, -0.5) + 0.1 - 0.121;
    EXPECT_NEAR(ascent.changes_after(-0.5), state == SensorState::coasting ? left_s : 0.1, 0.003);
  }
}

TEST(BurnOutGate, AHoldBeginsAnewAfterAReset) {
  GatedAscent ascent{until(DormantUntil::burn_out)};
  ascent.reads(5.0, ms(2'000));
  ascent.reads(-0.5, ms(60));
  ascent.now += ms(200);
  ascent.gate.interrupt();
  EXPECT_NEAR(ascent.changes_after(-0.5), 0.1, 0.003);
}

}  // namespace
}  // namespace fantail::core
