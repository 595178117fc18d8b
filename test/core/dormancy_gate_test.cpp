// SPDX-License-Identifier: MIT
#include "core/dormancy_gate.hpp"

#include "gated_ascent.hpp"
#include "seed.hpp"
#include "state_copy.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

TEST(DormancyGate, OneThatWaitsForTheGuideAloneIsOpenWhateverHappens) {
  GatedAscent ascent{until(DormantUntil::guide)};
  EXPECT_TRUE(ascent.gate.is_open());
  ascent.motion.accelerometer = SensorState::failed;
  EXPECT_TRUE(ascent.reads(5.0, ms(1'000)));
}

// At one height the pressure goes with the square of the speed.
TEST(PressureGate, OpensTwoPercentBelowTheLargestAndANewLargestOneClosesIt) {
  GatedAscent ascent{until(DormantUntil::max_dynamic_pressure)};
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
    GatedAscent ascent{until(DormantUntil::max_dynamic_pressure)};
    double height_m = from_m;
    while (!ascent.flies_at(200.0, height_m)) {
      height_m += 0.2;
    }
    EXPECT_NEAR(density_ratio(height_m) / density_ratio(from_m), 0.98, 0.0005) << from_m;
  }
}

TEST(PressureGate, StaysClosedAfterATimeInWhichTheSpeedWasNotMeasured) {
  for (const bool accelerometer : {true, false}) {
    GatedAscent ascent{until(DormantUntil::max_dynamic_pressure)};
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
  GatedAscent ascent{until(DormantUntil::max_dynamic_pressure)};
  ascent.flies_at(100.0);
  EXPECT_FALSE(ascent.flies_at(10.0, std::nan("")));
}

TEST(PressureGate, StaysClosedForWhatSomebodyCarries) {
  GatedAscent ascent{until(DormantUntil::max_dynamic_pressure)};
  ascent.motion.speed_m_s = 15.0F;
  ascent.flies_at(15.0);
  EXPECT_FALSE(ascent.flies_at(1.0));
}

/// Straight up by the closed form: at `acceleration_m_s2` after t seconds. At which height the gate opens.
double height_at_opening(const DormancyPlan& plan, double acceleration_m_s2) {
  GatedAscent ascent{plan};
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
  GatedAscent ascent{until(DormantUntil::height)};
  ASSERT_TRUE(ascent.flies_at(100.0, 600.0));
  EXPECT_TRUE(ascent.flies_at(100.0, 100.0));
}

TEST(HeightGate, StaysClosedAfterATimeWithoutAccelerometerOrWithAGyroAtTheEndOfItsRange) {
  for (const bool accelerometer : {true, false}) {
    GatedAscent ascent{until(DormantUntil::height)};
    ascent.motion.accelerometer = accelerometer ? SensorState::failed : SensorState::fresh;
    ascent.motion.rate_is_lower_bound = !accelerometer;
    ascent.flies_at(100.0, 100.0);
    ascent.motion.accelerometer = SensorState::fresh;
    ascent.motion.rate_is_lower_bound = false;
    EXPECT_FALSE(ascent.flies_at(100.0, 20'000.0));
  }
  GatedAscent ascent{until(DormantUntil::height)};
  ascent.motion.accelerometer = SensorState::lost;  // for a tick
  EXPECT_TRUE(ascent.flies_at(100.0, 600.0));
}

TEST(DormancyGate, OfTwoThingsToWaitForBothMustHaveCome) {
  for (const bool height_first : {true, false}) {
    GatedAscent burn{until(DormantUntil::burn_out_and_height)};
    burn.motion.height_m = height_first ? 600.0F : 100.0F;
    EXPECT_FALSE(burn.reads(5.0, ms(1'000)));
    EXPECT_EQ(burn.reads(-0.5, ms(1'000)), height_first);
    burn.motion.height_m = 700.0F;
    EXPECT_TRUE(burn.tick());

    GatedAscent pressure{until(DormantUntil::max_dynamic_pressure_and_height)};
    EXPECT_FALSE(pressure.flies_at(100.0, 10.0));
    EXPECT_EQ(pressure.flies_at(90.0, height_first ? 600.0 : 100.0), height_first);
    EXPECT_TRUE(pressure.flies_at(80.0, 700.0));
  }
}

TEST(DormancyGate, KnowsNothingOfAnEarlierLaunch) {
  GatedAscent ascent{until(DormantUntil::max_dynamic_pressure_and_height)};
  ascent.flies_at(100.0, 10.0);
  ASSERT_TRUE(ascent.flies_at(90.0, 600.0));
  ascent.gate.reset();
  EXPECT_FALSE(ascent.gate.is_open());
  EXPECT_FALSE(ascent.flies_at(80.0, 600.0)) << "the largest pressure so far";
}

// A motor that burns, pauses and burns again, beside speeds and heights that nothing explains: another gate that is
// given all that one remembers of it is open in the same ticks.
TEST(DormancyGate, OneThatIsGivenTheStateOfAnotherGoesOnAsTheOtherDoes) {
  std::mt19937 random{test::seed()};
  const auto between = [&random](int low, int high) { return std::uniform_int_distribution{low, high}(random); };
  int changes = 0;
  for (int flight = 0; flight < 300; ++flight) {
    GatedAscent ascent{until(static_cast<DormantUntil>(between(1, 5)))};
    for (int stretch = 0; stretch < 20; ++stretch) {
      DormancyGate given = ascent.gate;
      given.reset();
      copy_state(ascent.gate, given);
      const float axial_m_s2 = static_cast<float>(between(-8, 20));
      const float speed_m_s = static_cast<float>(between(10, 100));
      ascent.motion.height_m = static_cast<float>(between(0, 800));
      ascent.motion.accelerometer = between(0, 60) == 0 ? SensorState::failed : SensorState::fresh;
      ascent.motion.specific_force_m_s2.x = axial_m_s2;
      ascent.motion.speed_m_s = speed_m_s;
      ascent.motion.speed_squared_m2_s2 = speed_m_s * speed_m_s;
      for (int tick = between(1, 400); tick > 0; --tick) {
        const bool before = ascent.gate.is_open();
        ascent.tick();
        given.update(ascent.now, ascent.motion);
        ASSERT_EQ(given.is_open(), ascent.gate.is_open()) << flight << " " << stretch;
        changes += before != ascent.gate.is_open() ? 1 : 0;
      }
    }
  }
  EXPECT_GT(changes, 300);
}

}  // namespace
}  // namespace fantail::core
