// SPDX-License-Identifier: MIT
#include "bench/measurement.hpp"

#include "synthetic.hpp"
#include "test.hpp"

namespace fantail::bench {
namespace {

// What canard 2 shows alone.
Figures measured(Bench bench, const Exercise& exercise) {
  return measure(bench.record(exercise), exercise, exercise.turns()[0], 1);
}
Figures measured(const Bench& bench) { return measured(bench, Exercise::limits_of(six_degrees(), 1)); }

double deg(const std::optional<double>& radians) { return radians.value() / degree; }

TEST(Measurement, AnExactCanardShowsItself) {
  Bench bench;
  bench.canards[1].lag_s = 0.025;
  const Figures f = measured(bench);
  EXPECT_EQ(f.sign, 1);
  EXPECT_NEAR(f.gain.value(), 1.0, 2e-3);
  EXPECT_NEAR(deg(f.reached_positive_rad), 6.0, 0.01);
  EXPECT_NEAR(deg(f.reached_negative_rad), -6.0, 0.01);
  EXPECT_NEAR(deg(f.largest_command_rad), 6.0, 1e-6);
  EXPECT_TRUE(f.limit_reported.value());
  EXPECT_NEAR(f.lag_s.value(), 0.026, 0.001);  // read a tick before the command of the same tick
  EXPECT_LT(deg(f.tracking_error_rad), 0.02);
  EXPECT_NEAR(deg(f.centring_error_rad), 0.0, 0.005);
  EXPECT_NEAR(deg(f.backlash_rad), 0.0, 0.01);
  EXPECT_NEAR(f.step_time_s.value(), 0.025 * std::log(9.0), 0.001);  // of a first-order lag
  // Its mean speed over the first 10 ms of 12 deg.
  EXPECT_NEAR(deg(f.slew_rad_s), 12.0 * (1.0 - std::exp(-0.4)) / 0.01, 8.0);
  EXPECT_NEAR(deg(f.slew_way_rad), 12.0, 1e-6);
  EXPECT_NEAR(deg(f.overshoot_rad), 0.0, 0.02);
  EXPECT_LT(deg(f.noise_rad), 0.01);
  EXPECT_EQ(f.dropouts, 0U);
  EXPECT_NEAR(deg(f.others_moved_rad), 0.0, 0.02);
}

TEST(Measurement, TheLagIsFoundWhateverItIs) {
  for (const double lag_s : {0.005, 0.02, 0.05, 0.1, 0.2}) {
    Bench bench;
    bench.canards[1].lag_s = lag_s;
    bench.canards[1].noise_rad = 0.022 * degree;
    const Figures f = measured(bench);
    EXPECT_NEAR(f.lag_s.value(), lag_s + 0.001, 0.001 + 0.01 * lag_s);
    EXPECT_LT(deg(f.tracking_error_rad), 0.05) << lag_s;
  }
}

TEST(Measurement, PlayIsTheDifferenceOfTheTwoApproaches) {
  for (const double play_deg : {0.1, 0.3, 1.0}) {
    Bench bench;
    bench.canards[1].play_rad = play_deg * degree;
    bench.canards[1].noise_rad = 0.022 * degree;
    const Figures f = measured(bench);
    EXPECT_NEAR(deg(f.backlash_rad), play_deg, 0.02);
    EXPECT_NEAR(deg(f.centring_error_rad), 0.0, 0.01);
    EXPECT_NEAR(deg(f.reached_positive_rad), 6.0 - play_deg / 2, 0.01);
    EXPECT_NEAR(deg(f.reached_negative_rad), -6.0 + play_deg / 2, 0.01);
  }
}

TEST(Measurement, AShareThatIsLostIsTheGain) {
  Bench bench;
  bench.canards[1].gain = 2.0 / 3.0;
  const Figures f = measured(bench);
  EXPECT_NEAR(f.gain.value(), 2.0 / 3.0, 2e-3);
  EXPECT_NEAR(f.slope.value(), 2.0 / 3.0, 5e-3);
  EXPECT_NEAR(f.positive_share.value(), 2.0 / 3.0, 2e-3);
  EXPECT_NEAR(f.negative_share.value(), 2.0 / 3.0, 2e-3);
  EXPECT_NEAR(deg(f.tracking_error_rad), 2.0, 0.02);  // a third of 6 deg
}

TEST(Measurement, TheOtherWayRoundIsANegativeSign) {
  Bench bench;
  bench.canards[1].gain = -1.0;
  const Figures f = measured(bench);
  EXPECT_EQ(f.sign, -1);
  EXPECT_NEAR(f.gain.value(), -1.0, 2e-3);
  EXPECT_NEAR(f.step_time_s.value(), 0.02 * std::log(9.0), 0.001);
}

TEST(Measurement, StandingStillIsNoSignAndNoSlew) {
  Bench bench;
  bench.canards[1].gain = 0.0;
  bench.canards[1].offset_rad = 2.0 * degree;
  bench.canards[1].noise_rad = 0.022 * degree;
  const Figures f = measured(bench);
  EXPECT_EQ(f.sign, 0);
  EXPECT_FALSE(f.slew_rad_s);
  EXPECT_FALSE(f.step_time_s);
  EXPECT_FALSE(f.lag_s);
  EXPECT_NEAR(deg(f.stands_at_rad), 2.0, 0.01);
}

TEST(Measurement, AnOffsetIsTheCentringErrorWithItsSign) {
  Bench bench;
  bench.canards[1].offset_rad = -1.5 * degree;
  const Figures f = measured(bench);
  EXPECT_NEAR(deg(f.centring_error_rad), -1.5, 0.01);
  EXPECT_NEAR(deg(f.backlash_rad), 0.0, 0.01);
  EXPECT_NEAR(f.gain.value(), 1.0, 2e-3);
}

TEST(Measurement, NoiseIsItsStandardDeviationAndMovesNothingElse) {
  for (const double noise_deg : {0.02, 0.1, 0.5}) {
    Bench bench;
    bench.canards[1].noise_rad = noise_deg * degree;
    const Figures f = measured(bench);
    // About 1200 readings at rest: four standard deviations of a standard deviation are 8 %.
    EXPECT_NEAR(deg(f.noise_rad), noise_deg, 0.08 * noise_deg + 0.001);
    EXPECT_NEAR(deg(f.centring_error_rad), 0.0, 0.2 * noise_deg);
    EXPECT_NEAR(f.gain.value(), 1.0, 0.03 * noise_deg + 0.002);
    EXPECT_NEAR(f.step_time_s.value(), 0.02 * std::log(9.0), 0.002 + 0.02 * noise_deg);
  }
}

TEST(Measurement, ARateLimitIsTheSlewRate) {
  for (const double rate_deg_s : {50.0, 150.0, 300.0}) {
    Bench bench;
    bench.canards[1].lag_s = 0.002;
    bench.canards[1].fastest_rad_s = rate_deg_s * degree;
    bench.canards[1].noise_rad = 0.022 * degree;
    EXPECT_NEAR(deg(measured(bench).slew_rad_s), rate_deg_s, 8.0);  // 11 ms of this noise: 2 deg/s, the worst of many
  }
}

TEST(Measurement, DropoutsAreCountedAndDoNotDisturbTheRest) {
  Bench bench;
  bench.canards[1].dropout_share = 0.1;
  const Figures f = measured(bench);
  EXPECT_NEAR(f.dropout_share(), 0.1, 0.02);
  EXPECT_EQ(f.received_ticks, 4400U);
  EXPECT_NEAR(f.gain.value(), 1.0, 2e-3);
  EXPECT_NEAR(f.step_time_s.value(), 0.02 * std::log(9.0), 0.0015);
}

TEST(Measurement, LostTicksDoNotStretchTime) {
  Bench bench;
  bench.lost_share = 0.2;
  bench.canards[1].lag_s = 0.03;
  const Figures f = measured(bench);
  EXPECT_LT(f.received_ticks, 3700U);
  EXPECT_EQ(f.dropouts, 0U);
  EXPECT_NEAR(f.step_time_s.value(), 0.03 * std::log(9.0), 0.002);
  EXPECT_NEAR(f.lag_s.value(), 0.031, 0.002);
}

TEST(Measurement, MarksThatAreLateAndRequestsThatAreCoarseChangeNothing) {
  Bench bench;
  bench.marks_late_ms = 12;
  bench.marks_scatter_ms = 8;
  bench.requests_every_ms = 20;
  bench.canards[1].play_rad = 0.2 * degree;
  const Figures f = measured(bench);
  EXPECT_NEAR(deg(f.backlash_rad), 0.2, 0.01);
  EXPECT_NEAR(deg(f.reached_positive_rad), 5.9, 0.01);
  EXPECT_NEAR(f.step_time_s.value(), 0.02 * std::log(9.0), 0.0015);
  EXPECT_LT(deg(f.tracking_error_rad), 0.12);  // half the play, and what the fit leaves
}

TEST(Measurement, AnotherCanardThatGoesAlongIsSeen) {
  Bench bench;
  bench.canards[3].answers_to = 1;
  bench.canards[3].gain = 0.25;
  const Figures f = measured(bench);
  EXPECT_EQ(f.other_canard, 3U);
  EXPECT_NEAR(deg(f.others_moved_rad), 1.5, 0.02);
}

TEST(Measurement, NoiseOfAnotherCanardIsNotAMovement) {
  Bench bench;
  bench.canards[3].noise_rad = 2.0 * degree;
  EXPECT_LT(deg(measured(bench).others_moved_rad), 0.3);
}

TEST(Measurement, AnAvionicsThatDoesNotReportItsClampingIsSeen) {
  Bench bench;
  bench.reports_limited = false;
  EXPECT_FALSE(measured(bench).limit_reported.value());
}

TEST(Measurement, BeyondWhatTheBusCarriesIsNotAnAngle) {
  Bench bench;
  bench.canards[1].gain = 1.1;  // 22 deg, and the bus says 20.47
  EXPECT_TRUE(measured(bench, Exercise::limits_of(six_degrees(20.0), 1)).saturated);
  bench.canards[1].gain = 1.0;
  EXPECT_FALSE(measured(bench, Exercise::limits_of(six_degrees(20.0), 1)).saturated);
}

TEST(Measurement, OfASineAFirstOrderLagKeepsAmplitudeAndPhase) {
  Bench bench;
  bench.canards[1].lag_s = 0.02;
  for (const double frequency_hz : {1.0, 3.0, 8.0}) {
    const Exercise exercise =
        Exercise::sine(six_degrees(), 1, {.amplitude_rad = 4.0 * degree, .frequency_hz = frequency_hz, .cycles = 12});
    const Figures f = measured(bench, exercise);
    const double w = 2.0 * std::numbers::pi * frequency_hz;
    EXPECT_NEAR(f.amplitude_ratio.value(), 1.0 / std::hypot(1.0, 0.02 * w), 0.005);
    // Held for a millisecond, read a tick later: half a tick more than the lag.
    EXPECT_NEAR(f.phase_lag_rad.value(), std::atan(0.02 * w) + 0.0005 * w, 0.01);
  }
}

TEST(Measurement, AStepToAnAngleIsMeasuredLikeTheOneToTheLimit) {
  const Bench bench;
  const Figures f = measured(bench, Exercise::step(six_degrees(), 1, -4.0 * degree));
  EXPECT_NEAR(deg(f.reached_positive_rad), -4.0, 0.01);
  EXPECT_NEAR(f.step_time_s.value(), 0.02 * std::log(9.0), 0.001);
  EXPECT_EQ(f.sign, 1);
}

TEST(Measurement, WhatWasNotRecordedIsNotMeasured) {
  const Exercise exercise = Exercise::limits(six_degrees());
  for (const link::Recording& recording : {link::Recording{}, [] {
                                             link::Recording one;
                                             one.add({.number = 5});
                                             return one;
                                           }()}) {
    for (const Turn& turn : exercise.turns()) {
      const Figures f = measure(recording, exercise, turn, 0);
      EXPECT_FALSE(f.sign);
      EXPECT_FALSE(f.gain);
      EXPECT_FALSE(f.step_time_s);
      EXPECT_FALSE(f.noise_rad);
    }
  }
}

// A cable pulled at any moment must not be an error of the program.
TEST(Measurement, EveryCutOfARecordingCanBeMeasured) {
  Bench bench;
  const Exercise exercise = Exercise::limits_of(six_degrees(), 1);
  const link::Recording whole = bench.record(exercise);
  for (std::size_t end = 0; end < whole.ticks().size(); end += 97) {
    link::Recording cut;
    for (const link::Tick& tick : whole.ticks().first(end)) {
      cut.add(tick);
    }
    const Figures f = measure(cut, exercise, exercise.turns()[0], 1);
    EXPECT_EQ(f.received_ticks, end);
  }
}

}  // namespace
}  // namespace fantail::bench
