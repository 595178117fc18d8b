// SPDX-License-Identifier: MIT
#include "core/launch_detector.hpp"

#include "launch_detector_rig.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

// A pulse on top of a second of standing still; `next` gives the time of the sample after the one at t.
bool fires_on_pulse(const LaunchDetectionPlan& plan, float pulse_g, Microseconds length,
                    const std::function<Microseconds(Microseconds)>& next) {
  Bench bench{plan};
  const Microseconds begin{1'000'000};
  bool fired = false;
  for (Microseconds t{0}; t < Microseconds{2'000'000}; t = next(t)) {
    const bool inside = t >= begin && t < begin + length;
    fired = bench.feed(t, inside ? pulse_g : 1.0F) == DetectionState::detected || fired;
  }
  return fired;
}

struct Pulse {
  float level_g;
  Microseconds length;
  bool fires_launch_1;
  bool fires_launch_2;
};

// Row 15 of the table of expected results.
const Pulse row_15[] = {{20.0F, ms(50), false, false},
                        {5.0F, ms(150), false, true},
                        {3.0F, ms(195), false, true},
                        {3.0F, ms(205), true, true}};

TEST(LaunchDetector, TellsThePulsesOfTheOracleTableApartAtAnySampling) {
  const auto at_1_khz = [](Microseconds t) { return t + ms(1); };
  const auto at_400_hz = [](Microseconds t) { return t + Microseconds{2'500}; };
  // 0.6 to 1.4 ms, from the time itself.
  const auto jittered = [](Microseconds t) { return t + Microseconds{600 + t.count() * 7919 % 801}; };
  for (const Pulse& pulse : row_15) {
    for (const auto& next : {std::function<Microseconds(Microseconds)>{at_1_khz}, {at_400_hz}, {jittered}}) {
      EXPECT_EQ(fires_on_pulse(launch_1_rule(), pulse.level_g, pulse.length, next), pulse.fires_launch_1)
          << pulse.level_g << " g for " << pulse.length.count() << " us";
      EXPECT_EQ(fires_on_pulse(launch_2_rule(), pulse.level_g, pulse.length, next), pulse.fires_launch_2)
          << pulse.level_g << " g for " << pulse.length.count() << " us";
    }
  }
}

TEST(LaunchDetector, FiresAtTheFirstSampleWhoseElapsedTimeReachesTheHold) {
  Bench bench{launch_1_rule()};
  bench.hold_level(ms(0), ms(100), 1.0F);
  EXPECT_EQ(bench.hold_level(ms(100), ms(400), 3.0F), ms(300));
}

TEST(LaunchDetector, MeasuresTheHoldByTheTimestampsNotByTheNumberOfSamples) {
  Bench bench{launch_1_rule()};
  EXPECT_EQ(bench.feed(Microseconds{1'000'000}, 3.0F), DetectionState::holding);
  for (int i = 1; i < 100; ++i) {  // a hundred samples in 1 ms of sample time
    EXPECT_EQ(bench.feed(Microseconds{1'000'000 + 10 * i}, 3.0F), DetectionState::holding);
  }
  Microseconds t{1'001'000};
  for (; t < Microseconds{1'199'999}; t += stale_time) {  // just no gap
    EXPECT_EQ(bench.feed(t, 3.0F), DetectionState::holding);
  }
  EXPECT_EQ(bench.feed(Microseconds{1'199'999}, 3.0F), DetectionState::holding);
  EXPECT_EQ(bench.feed(Microseconds{1'200'000}, 3.0F), DetectionState::detected);
}

TEST(LaunchDetector, ThresholdItselfCounts) {
  Bench bench{launch_1_rule()};
  EXPECT_EQ(bench.hold_level(ms(0), ms(250), 2.0F), ms(200));
}

TEST(LaunchDetector, OneSampleBelowTheThresholdRestartsTheHold) {
  Bench bench{launch_1_rule()};
  EXPECT_EQ(bench.hold_level(ms(0), ms(199), 3.0F), std::nullopt);
  EXPECT_EQ(bench.feed(ms(199), 1.99F), DetectionState::quiet);
  EXPECT_EQ(bench.hold_level(ms(200), ms(500), 3.0F), ms(400));
}

TEST(LaunchDetector, RepeatedSampleAddsNoTime) {
  Bench bench{launch_1_rule()};
  bench.hold_level(ms(0), ms(199), 3.0F);
  const AccelerometerSample last = sample(ms(198), 3.0F);
  for (int now = 199; now <= 203; ++now) {
    EXPECT_EQ(bench.feed(ms(now), last, last), DetectionState::holding);
  }
  EXPECT_EQ(bench.feed(ms(203), 3.0F), DetectionState::detected);
}

TEST(LaunchDetector, StaleInvalidAbsentAndNotFiniteSamplesRestartTheHold) {
  const float infinity = std::numeric_limits<float>::infinity();
  const AccelerometerSample bad_ones[] = {
      sample(ms(193), 3.0F),  // 6 ms old, and older than the last one
      sample(ms(200), 3.0F),  // from the future
      sample(ms(199), 3.0F, SampleQuality::invalid),
      sample(ms(199), 3.0F, SampleQuality::absent),
      AccelerometerSample{},
      sample(ms(199), infinity),
      sample(ms(199), -infinity),
      sample(ms(199), std::numeric_limits<float>::quiet_NaN()),
      sample(ms(199), std::numeric_limits<float>::quiet_NaN(), SampleQuality::saturated),
      sample(ms(199), 3e37F),  // a number, but nothing that an accelerometer could mean
      sample(Microseconds::min(), 3.0F),
      sample(Microseconds::max(), 3.0F),
  };
  for (const LaunchDetectionPlan& plan : {launch_1_rule(), launch_2_rule()}) {
    for (const AccelerometerSample& bad : bad_ones) {
      Bench bench{plan};
      const Microseconds begin = ms(199) - plan.hold + ms(1);
      EXPECT_EQ(bench.hold_level(begin, ms(199), 3.0F), std::nullopt);
      EXPECT_EQ(bench.feed(ms(199), bad, sample(ms(199), 3.0F)), DetectionState::bad_sample);
      EXPECT_EQ(bench.hold_level(ms(200), ms(500), 3.0F), ms(200) + plan.hold);
    }
  }
}

TEST(LaunchDetector, ATickThatComesTwiceAddsAndTakesNothing) {
  Bench bench{launch_1_rule()};
  bench.hold_level(ms(0), ms(100), 3.0F);
  EXPECT_EQ(bench.feed(ms(99), 3.0F), DetectionState::holding);
  EXPECT_EQ(bench.hold_level(ms(100), ms(500), 3.0F), ms(200));
}

TEST(LaunchDetector, IsQuietAgainWhenADetectionIsOver) {
  Bench bench{launch_1_rule()};
  bench.hold_level(ms(0), ms(200), 3.0F);
  EXPECT_EQ(bench.feed(ms(200), 3.0F), DetectionState::detected);
  EXPECT_EQ(bench.feed(ms(201), 1.0F), DetectionState::quiet);
  EXPECT_EQ(bench.feed(ms(202), 3.0F), DetectionState::holding);
}

TEST(LaunchDetector, SampleThatIsReadAgainUntilItIsStaleRestartsTheHold) {
  Bench bench{launch_1_rule()};
  bench.hold_level(ms(0), ms(199), 3.0F);
  const AccelerometerSample last = sample(ms(198), 3.0F);
  EXPECT_EQ(bench.feed(ms(203), last, last), DetectionState::holding);
  EXPECT_EQ(bench.feed(ms(204), last, last), DetectionState::bad_sample);
  EXPECT_EQ(bench.hold_level(ms(205), ms(500), 3.0F), ms(405));
}

TEST(LaunchDetector, GapWithoutTicksRestartsTheHold) {
  Bench bench{launch_1_rule()};
  EXPECT_EQ(bench.feed(ms(1'000), 3.0F), DetectionState::holding);
  // What happened in these three seconds nobody measured.
  EXPECT_EQ(bench.hold_level(ms(4'000), ms(4'500), 3.0F), ms(4'200));
}

TEST(LaunchDetector, LostSampleDoesNotPrimeTheLowPassAnew) {
  LaunchDetectionPlan plan = launch_1_rule();
  plan.low_pass = true;
  Bench bench{plan};
  bench.hold_level(ms(0), ms(100), 1.0F);
  bench.feed(ms(100), AccelerometerSample{}, AccelerometerSample{});
  // A knock of one sample: 1 - exp(-2 ms / 9.95 ms) of the step is 1.73 g, still below 2 g.
  EXPECT_EQ(bench.feed(ms(101), 5.0F), DetectionState::quiet);
}

TEST(LaunchDetector, ClockThatJumpsBackStartsOverAndThenWorks) {
  Bench bench{launch_1_rule()};
  bench.hold_level(ms(10'000), ms(10'100), 3.0F);
  EXPECT_EQ(bench.hold_level(ms(500), ms(1'000), 3.0F), ms(700));
  EXPECT_EQ(bench.hold_level(ms(996), ms(1'500), 3.0F), ms(1'196)) << "by less than a sample may be old";
}

TEST(LaunchDetector, SampleAtThePositiveEndCountsAsAboveWhateverItReads) {
  Bench bench{launch_1_rule()};
  for (int t = 0; t < 200; ++t) {
    const AccelerometerSample end = sample(ms(t), 1.5F, SampleQuality::saturated);
    EXPECT_EQ(bench.feed(ms(t), end, end), DetectionState::holding);
  }
  EXPECT_EQ(bench.feed(ms(200), 3.0F), DetectionState::detected);
}

TEST(LaunchDetector, NegativeSpecificForceIsNoLaunch) {
  Bench bench{launch_1_rule()};
  EXPECT_EQ(bench.hold_level(ms(0), ms(1'000), -5.0F), std::nullopt);
}
TEST(LaunchDetector, LowPassIsPrimedByTheFirstSampleAndTheHoldIsMeasuredOnItsOutput) {
  LaunchDetectionPlan plan = launch_1_rule();
  plan.low_pass = true;
  Bench primed{plan};
  EXPECT_EQ(primed.hold_level(ms(0), ms(300), 3.0F), ms(200));

  // From 1 g, a step to 3 g passes 2 g after ln 2 time constants of 9.947 ms: 6.895 ms after the sample before it.
  Bench stepped{plan};
  stepped.hold_level(ms(0), ms(1'000), 1.0F);
  EXPECT_EQ(stepped.hold_level(ms(1'000), ms(1'500), 3.0F), ms(999 + 7 + 200));
}

TEST(LaunchDetector, LowPassRidesOverOneSampleBelowTheThreshold) {
  LaunchDetectionPlan plan = launch_1_rule();
  plan.low_pass = true;
  Bench bench{plan};
  bench.hold_level(ms(0), ms(100), 4.0F);
  EXPECT_EQ(bench.feed(ms(100), 0.0F), DetectionState::holding);
  EXPECT_EQ(bench.hold_level(ms(101), ms(300), 4.0F), ms(200));
}

// What the low-pass costs: it stretches a hard knock by ln(15 g / 1.5 g) time constants, 23 ms. The guide clearance
// catches this one (AutopilotFlight, KnockThatFiresTheLowPassedRuleNeverMovesACanard).
TEST(LaunchDetector, KnockOf16GFor80MsFiresTheLowPassedRuleAndNotTheRawOne) {
  for (const bool low_pass : {false, true}) {
    LaunchDetectionPlan plan = launch_2_rule();
    plan.low_pass = low_pass;
    Bench bench{plan};
    bench.hold_level(ms(0), ms(1'000), 1.0F);
    EXPECT_EQ(bench.hold_level(ms(1'000), ms(1'080), 16.0F), std::nullopt);
    EXPECT_EQ(bench.hold_level(ms(1'080), ms(2'000), 1.0F).has_value(), low_pass);
  }
}

TEST(LaunchDetector, WorksTheSameAfterAWeekOfWaiting) {
  Bench bench{launch_1_rule()};
  const Microseconds week{7LL * 86'400'000'000};
  EXPECT_EQ(bench.hold_level(week, week + ms(300), 3.0F), week + ms(200));
}

}  // namespace
}  // namespace fantail::core
