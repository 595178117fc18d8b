// SPDX-License-Identifier: MIT
#include "core/dormancy_gate.hpp"

#include "core/flight_plan_fields.hpp"
#include "milliseconds.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

constexpr double g_m_s2 = 9.80665;

DormancyPlan until(DormantUntil what, float height_m = 500.0F) {
  DormancyPlan plan = default_plan().dormancy;
  plan.until = what;
  plan.height_m = height_m;
  plan.burn_time = ms(1'000);
  return plan;
}

/// A gate and what it is shown, at 1 kHz; first thrust is at zero.
class Ascent {
 public:
  explicit Ascent(const DormancyPlan& plan) : gate{plan} {
    motion.gyro = motion.accelerometer = SensorState::fresh;
    motion.speed_m_s = 50.0F;
  }

  bool tick() {
    now += ms(1);
    gate.update(now, motion);
    return gate.is_open();
  }
  bool reads(double axial_g, Microseconds length) {
    motion.specific_force_m_s2.x = static_cast<float>(axial_g * g_m_s2);
    for (const Microseconds end = now + length; now < end;) {
      tick();
    }
    return gate.is_open();
  }
  /// From now on, reading this: after how long the gate is another one, in seconds.
  double changes_after(double axial_g) {
    const bool before = gate.is_open();
    const Microseconds begin = now;
    while (gate.is_open() == before && now - begin < ms(120'000)) {
      reads(axial_g, ms(1));
    }
    return static_cast<double>((now - begin).count()) * 1e-6;
  }
  bool flies_at(double speed_m_s, double height_m = 0.0) {
    motion.velocity_m_s = {static_cast<float>(0.6 * speed_m_s), 0.0F, static_cast<float>(0.8 * speed_m_s)};
    motion.height_m = static_cast<float>(height_m);
    return tick();
  }

  DormancyGate gate;
  Motion motion;
  Microseconds now{};
};

/// How long an 8 Hz low-pass takes from one level past another, on its way to a third.
double lag_s(double from, double past, double to) {
  return std::log((from - to) / (past - to)) / (2.0 * std::numbers::pi * 8.0);
}

TEST(DormancyGate, OneThatWaitsForTheGuideAloneIsOpenWhateverHappens) {
  Ascent ascent{until(DormantUntil::guide)};
  EXPECT_TRUE(ascent.gate.is_open());
  ascent.motion.accelerometer = SensorState::failed;
  EXPECT_TRUE(ascent.reads(5.0, ms(1'000)));
}

TEST(BurnOutGate, OpensATenthOfASecondAfterTheLowPassedThrustIsOver) {
  Ascent ascent{until(DormantUntil::burn_out)};
  EXPECT_FALSE(ascent.reads(5.0, ms(2'000)));
  EXPECT_NEAR(ascent.changes_after(-0.5), lag_s(5.0, 0.15, -0.5) + 0.1, 0.002);
}

TEST(BurnOutGate, DoesNotBelieveAThrustThatIsOverBeforeTheClock) {
  Ascent ascent{until(DormantUntil::burn_out)};
  ascent.reads(5.0, ms(500));
  EXPECT_NEAR(0.5 + ascent.changes_after(-0.5), 1.1, 0.0011);  // the factor times the burn time
}

TEST(BurnOutGate, TheClockRunsFromFirstThrustAndHasTheFactorOfThePlan) {
  DormancyPlan plan = until(DormantUntil::burn_out);
  plan.burn_clock_factor = 1.5F;
  Ascent ascent{plan};
  ascent.motion.thrust_since = ms(250);
  EXPECT_NEAR(ascent.changes_after(-0.5), 0.25 + 1.5, 0.0011);
}

TEST(BurnOutGate, NeverOpensByTimeAlone) {
  Ascent pushed{until(DormantUntil::burn_out)};
  EXPECT_FALSE(pushed.reads(0.16, ms(120'000)));
  Ascent carried{until(DormantUntil::burn_out)};
  carried.motion.speed_m_s = 15.0F;
  EXPECT_FALSE(carried.reads(-1.0, ms(120'000)));
  carried.motion.speed_m_s = 15.1F;
  EXPECT_TRUE(carried.reads(-1.0, ms(1)));
}

TEST(BurnOutGate, AnAccelerometerThatReadsATenthOfAGTooMuchDoesNotHideIt) {
  Ascent ascent{until(DormantUntil::burn_out)};
  ascent.reads(5.1, ms(2'000));
  EXPECT_NEAR(ascent.changes_after(0.1), lag_s(5.1, 0.15, 0.1) + 0.1, 0.002);
}

TEST(BurnOutGate, APauseThatEndsInThrustIsTakenOffTheClock) {
  Ascent ascent{until(DormantUntil::burn_out)};
  ascent.reads(5.0, ms(300));
  EXPECT_FALSE(ascent.reads(-0.5, ms(600)));
  EXPECT_FALSE(ascent.reads(5.0, ms(400)));
  // It began when the low-pass fell below 0.15 g, and ended when it rose above 1 g.
  const double pause_s = 0.6 - lag_s(5.0, 0.15, -0.5) + lag_s(-0.5, 1.0, 5.0);
  EXPECT_NEAR(1.3 + ascent.changes_after(-0.5), 1.1 + pause_s, 0.003);
}

TEST(BurnOutGate, ThrustAgainForATenthOfASecondClosesIt) {
  for (const int length_ms : {60, 140}) {
    Ascent ascent{until(DormantUntil::burn_out)};
    ascent.reads(5.0, ms(1'000));
    ASSERT_TRUE(ascent.reads(-0.5, ms(1'000)));
    ascent.reads(5.0, ms(length_ms));
    EXPECT_TRUE(length_ms < 100 ? ascent.reads(-0.5, ms(1)) : !ascent.reads(5.0, ms(1)));
  }
  Ascent ascent{until(DormantUntil::burn_out)};
  ascent.reads(5.0, ms(1'000));
  ASSERT_TRUE(ascent.reads(-0.5, ms(1'000)));
  EXPECT_TRUE(ascent.reads(0.99, ms(5'000))) << "what pushes less than 1 g closes nothing";
  EXPECT_NEAR(ascent.changes_after(3.0), lag_s(0.99, 1.0, 3.0) + 0.1, 0.002);
}

TEST(BurnOutGate, AHoldBeginsAnewWhereNothingWasMeasured) {
  for (const SensorState state : {SensorState::lost, SensorState::failed, SensorState::coasting}) {
    Ascent ascent{until(DormantUntil::burn_out)};
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
  Ascent ascent{until(DormantUntil::burn_out)};
  ascent.reads(5.0, ms(2'000));
  ascent.reads(-0.5, ms(60));
  ascent.now += ms(200);
  ascent.gate.interrupt();
  EXPECT_NEAR(ascent.changes_after(-0.5), 0.1, 0.003);
}

// At one height the pressure goes with the square of the speed.
TEST(PressureGate, OpensTwoPercentBelowTheLargestAndANewLargestOneClosesIt) {
  Ascent ascent{until(DormantUntil::max_dynamic_pressure)};
  EXPECT_FALSE(ascent.flies_at(100.0));
  EXPECT_FALSE(ascent.flies_at(100.01 * std::sqrt(0.98)));
  EXPECT_TRUE(ascent.flies_at(99.9 * std::sqrt(0.98)));
  EXPECT_TRUE(ascent.flies_at(99.9));
  EXPECT_FALSE(ascent.flies_at(100.1)) << "a second peak, higher than the first";
  EXPECT_FALSE(ascent.flies_at(100.11 * std::sqrt(0.98)));
  EXPECT_TRUE(ascent.flies_at(100.0 * std::sqrt(0.98)));
}

// In the standard atmosphere; at a constant speed the air alone makes the pressure fall.
TEST(PressureGate, CountsTheAirThatGetsThinner) {
  const auto density_ratio = [](double height_m) { return std::pow(1.0 - 2.25577e-5 * height_m, 4.25588); };
  for (const double from_m : {0.0, 3'000.0, 8'000.0}) {
    Ascent ascent{until(DormantUntil::max_dynamic_pressure)};
    double height_m = from_m;
    while (!ascent.flies_at(200.0, height_m)) {
      height_m += 0.2;
    }
    EXPECT_NEAR(density_ratio(height_m) / density_ratio(from_m), 0.98, 0.0005) << from_m;
  }
}

TEST(PressureGate, StaysClosedAfterATimeInWhichTheSpeedWasNotMeasured) {
  for (const bool accelerometer : {true, false}) {
    Ascent ascent{until(DormantUntil::max_dynamic_pressure)};
    ascent.flies_at(100.0);
    ascent.motion.accelerometer = accelerometer ? SensorState::failed : SensorState::fresh;
    ascent.motion.rate_is_lower_bound = !accelerometer;
    ascent.tick();
    ascent.motion.accelerometer = SensorState::fresh;
    ascent.motion.rate_is_lower_bound = false;
    for (int i = 0; i < 1'000; ++i) {
      ASSERT_FALSE(ascent.flies_at(90.0 - 0.05 * i));
    }
  }
}

TEST(PressureGate, APressureThatIsNoNumberHasNotFallen) {
  Ascent ascent{until(DormantUntil::max_dynamic_pressure)};
  ascent.flies_at(100.0);
  EXPECT_FALSE(ascent.flies_at(10.0, std::nan("")));
}

TEST(PressureGate, StaysClosedForWhatSomebodyCarries) {
  Ascent ascent{until(DormantUntil::max_dynamic_pressure)};
  ascent.motion.speed_m_s = 15.0F;
  ascent.flies_at(15.0);
  EXPECT_FALSE(ascent.flies_at(1.0));
}

/// Straight up by the closed form: at `acceleration_m_s2` after t seconds. At which height the gate opens.
double height_at_opening(const DormancyPlan& plan, double acceleration_m_s2) {
  Ascent ascent{plan};
  double height_m = 0.0;
  do {
    const double t_s = static_cast<double>(ascent.now.count() + 1'000) * 1e-6;
    height_m = 0.5 * acceleration_m_s2 * t_s * t_s;
    ascent.motion.height_m = static_cast<float>(height_m);
  } while (!ascent.tick());
  return height_m;
}

// With h = a t^2 / 2: h - s (h + g t^2 / 2) - b t^2 / 2 = H, so h = H a / (a - s (a + g) - b).
TEST(HeightGate, OpensWhereTheLowEndOfWhatTheHeightCanBeIsAboveThatOfThePlan) {
  for (const double wanted_m : {200.0, 1'500.0, 3'000.0}) {
    for (const auto& [scale, bias_g] : {std::pair{0.01, 0.06}, std::pair{0.0, 0.0}, std::pair{0.1, 0.5}}) {
      DormancyPlan plan = until(DormantUntil::height, static_cast<float>(wanted_m));
      plan.scale_error = static_cast<float>(scale);
      plan.bias_error_m_s2 = static_cast<float>(bias_g * g_m_s2);
      const double a = 25.0;
      const double expected_m = wanted_m * a / (a - scale * (a + g_m_s2) - bias_g * g_m_s2);
      // A tick of the way, and single precision.
      EXPECT_NEAR(height_at_opening(plan, a), expected_m, 0.001 * std::sqrt(2.0 * a * expected_m) + 1e-5 * expected_m)
          << wanted_m << " " << scale;
    }
  }
}

TEST(HeightGate, StaysOpenBelowAgain) {
  Ascent ascent{until(DormantUntil::height)};
  ASSERT_TRUE(ascent.flies_at(100.0, 600.0));
  EXPECT_TRUE(ascent.flies_at(100.0, 100.0));
}

TEST(HeightGate, StaysClosedAfterATimeWithoutAccelerometerOrWithAGyroAtTheEndOfItsRange) {
  for (const bool accelerometer : {true, false}) {
    Ascent ascent{until(DormantUntil::height)};
    ascent.motion.accelerometer = accelerometer ? SensorState::failed : SensorState::fresh;
    ascent.motion.rate_is_lower_bound = !accelerometer;
    ascent.flies_at(100.0, 100.0);
    ascent.motion.accelerometer = SensorState::fresh;
    ascent.motion.rate_is_lower_bound = false;
    EXPECT_FALSE(ascent.flies_at(100.0, 20'000.0));
  }
  Ascent ascent{until(DormantUntil::height)};
  ascent.motion.accelerometer = SensorState::lost;  // for a tick
  EXPECT_TRUE(ascent.flies_at(100.0, 600.0));
}

TEST(DormancyGate, OfTwoThingsToWaitForBothMustHaveCome) {
  for (const bool height_first : {true, false}) {
    Ascent burn{until(DormantUntil::burn_out_and_height)};
    burn.motion.height_m = height_first ? 600.0F : 100.0F;
    EXPECT_FALSE(burn.reads(5.0, ms(1'000)));
    EXPECT_EQ(burn.reads(-0.5, ms(1'000)), height_first);
    burn.motion.height_m = 700.0F;
    EXPECT_TRUE(burn.tick());

    Ascent pressure{until(DormantUntil::max_dynamic_pressure_and_height)};
    EXPECT_FALSE(pressure.flies_at(100.0, 10.0));
    EXPECT_EQ(pressure.flies_at(90.0, height_first ? 600.0 : 100.0), height_first);
    EXPECT_TRUE(pressure.flies_at(80.0, 700.0));
  }
}

TEST(DormancyGate, KnowsNothingOfAnEarlierLaunch) {
  Ascent ascent{until(DormantUntil::max_dynamic_pressure_and_height)};
  ascent.flies_at(100.0, 10.0);
  ASSERT_TRUE(ascent.flies_at(90.0, 600.0));
  ascent.gate.reset();
  EXPECT_FALSE(ascent.gate.is_open());
  EXPECT_FALSE(ascent.flies_at(80.0, 600.0)) << "the largest pressure so far";
}

}  // namespace
}  // namespace fantail::core
