// SPDX-License-Identifier: MIT

#include "core/flight_plan_fields.hpp"
#include "core/launch_detector.hpp"
#include "launch_detector_rig.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

TEST(LaunchDetector, TwoAccelerometersFireWhenBothOwnHoldsAreComplete) {
  LaunchDetectionPlan plan = launch_2_rule();
  plan.disagreement_m_s2 = 5.0F * g;
  Bench bench{plan};
  for (int t = 0; t < 140; ++t) {
    const DetectionState state = bench.feed(ms(t), 3.0F, t < 40 ? 2.0F : 3.0F);
    EXPECT_EQ(state, DetectionState::holding) << t;
  }
  EXPECT_EQ(bench.feed(ms(140), 3.0F, 3.0F), DetectionState::detected);
}

TEST(LaunchDetector, TwoAccelerometersMayBeReadAtDifferentInstants) {
  Bench bench{launch_2_rule()};
  std::optional<Microseconds> fired;
  for (int t = 0; t <= 120 && !fired; ++t) {
    // The second one runs at half the rate and 0.3 ms late.
    const Microseconds second = ms(t - t % 2) - Microseconds{300};
    if (bench.feed(ms(t), sample(ms(t), 3.0F), sample(second, 3.0F)) == DetectionState::detected) {
      fired = ms(t);
    }
  }
  EXPECT_EQ(fired, ms(100));
}

TEST(LaunchDetector, OneOfTwoAccelerometersAloneIsRefusedUnlessThePlanAllowsIt) {
  for (const bool allowed : {false, true}) {
    for (const bool first_is_lost : {false, true}) {
      LaunchDetectionPlan plan = launch_2_rule();
      plan.single_allowed = allowed;
      Bench bench{plan};
      std::optional<Microseconds> fired;
      for (int t = 0; t < 300; ++t) {
        const AccelerometerSample good = sample(ms(t), 3.0F);
        const auto state = first_is_lost ? bench.feed(ms(t), {}, good) : bench.feed(ms(t), good, {});
        EXPECT_TRUE(allowed || state == DetectionState::bad_sample) << t;
        if (state == DetectionState::detected && !fired) {
          fired = ms(t);
        }
      }
      EXPECT_EQ(fired, allowed ? std::optional{ms(100)} : std::nullopt);
    }
  }
}

TEST(LaunchDetector, RuleOfOneAccelerometerDoesNotLookAtTheSecond) {
  Bench bench{launch_1_rule()};
  DetectionState state = DetectionState::quiet;
  for (int t = 0; t <= 200; ++t) {
    state = bench.feed(ms(t), sample(ms(t), 3.0F), sample(ms(t), -7.0F));
  }
  EXPECT_EQ(state, DetectionState::detected);
}

TEST(LaunchDetector, DisagreementOfMoreThanHalfAGRestartsBothHolds) {
  Bench bench{launch_2_rule()};
  EXPECT_EQ(bench.hold_level(ms(0), ms(60), 3.0F), std::nullopt);
  Microseconds last_disagreement{};
  for (int t = 60; t < 80; ++t) {
    if (bench.feed(ms(t), 3.0F, 3.6F) == DetectionState::disagreement) {
      last_disagreement = ms(t);
    }
  }
  // The low-passed difference passes 0.5 of 0.6 g after 1.79 time constants of 9.95 ms: with the 18th sample.
  EXPECT_EQ(last_disagreement, ms(79));
  std::optional<Microseconds> fired;
  for (int t = 80; t < 300 && !fired; ++t) {
    const DetectionState state = bench.feed(ms(t), 3.0F);
    if (state == DetectionState::disagreement) {
      last_disagreement = ms(t);
    } else if (state == DetectionState::detected) {
      fired = ms(t);
    }
  }
  EXPECT_EQ(fired, last_disagreement + ms(101));
}

TEST(LaunchDetector, DisagreementUpToHalfAGIsCalibrationNotAFault) {
  Bench bench{launch_2_rule()};
  DetectionState state = DetectionState::quiet;
  for (int t = 0; t <= 100; ++t) {
    state = bench.feed(ms(t), 3.0F, 3.49F);
  }
  EXPECT_EQ(state, DetectionState::detected);
}

TEST(LaunchDetector, ADifferenceOfExactlyWhatThePlanAllowsIsAllowed) {
  LaunchDetectionPlan plan = launch_2_rule();
  plan.disagreement_m_s2 = 4.0F;
  const auto of = [](float axial_m_s2) {
    return AccelerometerSample{.specific_force_m_s2 = {axial_m_s2, 0.0F, 0.0F}, .quality = SampleQuality::valid};
  };
  for (const bool first_is_more : {false, true}) {
    Bench bench{plan};
    const auto state = first_is_more ? bench.feed({}, of(34.0F), of(30.0F)) : bench.feed({}, of(30.0F), of(34.0F));
    EXPECT_EQ(state, DetectionState::holding);
  }
}

TEST(LaunchDetector, SaturatedAccelerometerMayReadTooLittleButNotTooMuch) {
  Bench fair{launch_2_rule()};
  Bench stuck{launch_2_rule()};
  for (int t = 0; t <= 100; ++t) {
    const AccelerometerSample end = sample(ms(t), 16.0F, SampleQuality::saturated);
    EXPECT_EQ(fair.feed(ms(t), end, sample(ms(t), 20.0F)),
              t < 100 ? DetectionState::holding : DetectionState::detected);
    EXPECT_EQ(stuck.feed(ms(t), end, sample(ms(t), 3.0F)), DetectionState::disagreement);
  }
}

TEST(LaunchDetector, AfterADetectionTheTwoAgreeFromTheFirstTickOn) {
  Bench bench{launch_2_rule()};
  ASSERT_EQ(bench.hold_level(ms(0), ms(101), 3.0F), ms(100));
  for (int t = 101; t < 400; ++t) {
    ASSERT_TRUE(bench.agrees(ms(t), t < 200 ? 3.0F : -1.0F, t < 200 ? 3.0F : -1.0F)) << t;  // also without thrust
  }
}

TEST(LaunchDetector, ADisagreementAfterADetectionCountsForAQuarterOfASecond) {
  Bench bench{launch_2_rule()};
  ASSERT_EQ(bench.hold_level(ms(0), ms(101), 3.0F), ms(100));
  // The low-passed difference passes 0.5 of 2 g after 0.29 time constants of 9.95 ms, and is below it again after 1.37,
  // which are 13.6 ms: with the 14th sample, so that the 13th is the last that differs.
  std::optional<Microseconds> first;
  std::optional<Microseconds> last;
  for (int t = 101; t < 600; ++t) {
    if (!bench.agrees(ms(t), 3.0F, t < 140 ? 1.0F : 3.0F)) {
      first = first.value_or(ms(t));
      last = ms(t);
    }
  }
  EXPECT_EQ(first, ms(103));
  EXPECT_EQ(last, ms(152 + 249));

  Bench again{launch_2_rule()};
  ASSERT_EQ(again.hold_level(ms(0), ms(101), 3.0F), ms(100));
  for (int t = 101; t <= 401; ++t) {
    (void)again.agrees(ms(t), 3.0F, t < 140 ? 1.0F : 3.0F);
  }
  EXPECT_FALSE(again.agrees(ms(152 + 250) - Microseconds{1}, 3.0F, 3.0F));
  EXPECT_TRUE(again.agrees(ms(152 + 250), 3.0F, 3.0F));
}

TEST(LaunchDetector, AfterADetectionOneThatDoesNotMeasureDisagreesWithNobody) {
  for (const bool first_is_lost : {false, true}) {
    Bench bench{launch_2_rule()};
    ASSERT_EQ(bench.hold_level(ms(0), ms(101), 3.0F), ms(100));
    for (int t = 101; t < 500; ++t) {
      const AccelerometerSample other = sample(ms(t), 6.0F);
      EXPECT_TRUE(first_is_lost ? bench.agrees(ms(t), {}, other) : bench.agrees(ms(t), other, {})) << t;
    }
  }
}

TEST(LaunchDetector, AfterADetectionOneAtTheEndOfItsRangeMayReadTooLittle) {
  Bench bench{launch_2_rule()};
  ASSERT_EQ(bench.hold_level(ms(0), ms(101), 3.0F), ms(100));
  for (int t = 101; t < 500; ++t) {
    EXPECT_TRUE(bench.agrees(ms(t), sample(ms(t), 16.0F, SampleQuality::saturated), sample(ms(t), 20.0F))) << t;
  }
  EXPECT_FALSE(bench.agrees(ms(500), sample(ms(500), 16.0F, SampleQuality::saturated), sample(ms(500), -90.0F)));
}

TEST(LaunchDetector, RuleOfOneAccelerometerAsksNobodyWhetherItAgrees) {
  Bench bench{launch_1_rule()};
  ASSERT_EQ(bench.hold_level(ms(0), ms(201), 3.0F), ms(200));
  for (int t = 201; t < 300; ++t) {
    EXPECT_TRUE(bench.agrees(ms(t), 3.0F, -7.0F)) << t;
  }
}

TEST(LaunchDetector, WhoDisagreedInAFlightThatWasNoneMayBeDetectedAgain) {
  Bench bench{launch_2_rule()};
  ASSERT_EQ(bench.hold_level(ms(0), ms(101), 3.0F), ms(100));
  EXPECT_TRUE(bench.agrees(ms(101), 3.0F, 3.0F));
  for (int t = 102; t < 200; ++t) {
    (void)bench.agrees(ms(t), 3.0F, -3.0F);
  }
  bench.reset();
  ASSERT_EQ(bench.hold_level(ms(3'000), ms(3'101), 3.0F), ms(3'100));
  EXPECT_TRUE(bench.agrees(ms(3'101), 3.0F, 3.0F));
}

constexpr Microseconds stale_time{5'000};

class LaunchDetectorReset : public ::testing::Test {
 protected:
  LaunchDetectorReset() {
    plan.threshold_m_s2 = 2.0F * standard_gravity_m_s2;
    plan.hold = Microseconds{100'000};
    plan.low_pass = false;
  }
  static DetectionState feed(LaunchDetector& detector, int time_ms, float axial_g) {
    const Microseconds time{time_ms * 1'000};
    const AccelerometerSample sample{time, {axial_g * standard_gravity_m_s2, 0.0F, 0.0F}, SampleQuality::valid};
    return detector.update(time, {sample, sample});
  }

  LaunchDetectionPlan plan = default_plan().launch_detection;
};

TEST_F(LaunchDetectorReset, HoldThatWasAlmostCompleteIsForgotten) {
  LaunchDetector detector{plan, stale_time};
  for (int t = 0; t < 100; ++t) {
    feed(detector, t, 3.0F);
  }
  detector.reset();
  for (int t = 100; t < 200; ++t) {
    ASSERT_EQ(feed(detector, t, 3.0F), DetectionState::holding) << t;
  }
  EXPECT_EQ(feed(detector, 200, 3.0F), DetectionState::detected);
}

TEST_F(LaunchDetectorReset, LowPassIsPrimedByTheFirstSampleAfterIt) {
  plan.low_pass = true;
  LaunchDetector detector{plan, stale_time};
  for (int t = 0; t < 90; ++t) {
    feed(detector, t, 16.0F);
  }
  detector.reset();
  EXPECT_EQ(feed(detector, 90, 1.0F), DetectionState::quiet);
}

}  // namespace

}  // namespace fantail::core
