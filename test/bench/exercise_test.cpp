// SPDX-License-Identifier: MIT

#include "bench/exercise.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "bench/cycle.hpp"
#include "bench/perform.hpp"
#include "json/value.hpp"
#include "synthetic.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::bench {
namespace {

/// Laps whose figures rise evenly: the n-th has a lag of n ms, an rms error of n and a largest of 2 n thousandths of a
/// degree, and a battery of 12 V less n mV.
Cycle rising(std::size_t laps) {
  Cycle cycle{.lap_s = 5.0, .planned_laps = laps};
  for (std::size_t n = 1; n <= laps; ++n) {
    const auto value = static_cast<double>(n);
    Lap lap{.begin_s = 5.0 * (value - 1.0), .battery_v = 12.0 - 1e-3 * value, .passed = true};
    for (CanardLap& canard : lap.canards) {
      canard = {.lag_s = 1e-3 * value,
                .tracking_rms_rad = text::radians(1e-3 * value),
                .tracking_error_rad = text::radians(2e-3 * value),
                .passed = true};
    }
    cycle.laps.push_back(lap);
  }
  return cycle;
}

TEST(Cycle, EachFigureHasFirstLastWorstAndTenths) {
  const Cycle cycle = rising(40);
  const Course lag = lag_course(cycle, 2);
  EXPECT_DOUBLE_EQ(*lag.first, 0.001);
  EXPECT_DOUBLE_EQ(*lag.last, 0.040);
  EXPECT_DOUBLE_EQ(*lag.worst, 0.040);
  ASSERT_EQ(lag.tenths.size(), 10U);
  EXPECT_NEAR(*lag.tenths[0], 0.0025, 1e-12) << "the mean of 1 to 4 ms";
  EXPECT_NEAR(*lag.tenths[9], 0.0385, 1e-12);
  const Course rms = tracking_rms_course(cycle, 2);
  EXPECT_NEAR(*rms.tenths[0], text::radians(1e-3 * std::sqrt(30.0 / 4.0)), 1e-12);
  EXPECT_NEAR(*tracking_error_course(cycle, 2).tenths[0], text::radians(8e-3), 1e-12) << "the largest";
  const Course battery = battery_course(cycle);
  EXPECT_DOUBLE_EQ(*battery.worst, 11.96) << "the lowest";
  EXPECT_DOUBLE_EQ(*battery.tenths[0], 11.996);
}

TEST(Cycle, FewerThanTenLapsHaveFewerParts) {
  EXPECT_EQ(lag_course(rising(3), 0).tenths.size(), 3U);
  const Course none = lag_course(Cycle{}, 0);
  EXPECT_FALSE(none.first || none.last || none.worst);
  EXPECT_TRUE(none.tenths.empty());
}

TEST(Cycle, ALapThatWasLeftOutHasNoPartInAnyFigure) {
  Cycle cycle = rising(4);
  cycle.laps[3].doubt = "this PC was too slow";
  cycle.laps[3].passed = false;
  EXPECT_DOUBLE_EQ(*lag_course(cycle, 0).last, 0.003);
  EXPECT_EQ(judgement(cycle), Judgement::pass);
  EXPECT_EQ(conclusions(cycle)[0], "All four canards stayed within their tolerances in 3 laps of 5.0 s each.");
  EXPECT_EQ(conclusions(cycle)[1], "1 lap could not be measured and is left out.");
  const std::string csv = cycle_csv(cycle);
  EXPECT_TRUE(csv.ends_with("\n4,15.000,0,,,,,,,,,,,,,,,,,11.996\n")) << csv;
}

TEST(Cycle, SaysNothingOfTheCanardsWhenNothingWasMeasured) {
  const Cycle empty{.lap_s = 5.0, .planned_laps = 10};
  EXPECT_EQ(judgement(empty), Judgement::none);
  EXPECT_EQ(conclusions(empty), std::vector<std::string>{"No lap was measured, so the canards are not judged."});
}

TEST(Cycle, OneLapThatFailedFailsTheRunAndIsNamed) {
  Cycle cycle = rising(20);
  cycle.laps[7].passed = false;
  cycle.laps[7].conclusions = {"Canard 3 is slow: it is."};
  EXPECT_EQ(judgement(cycle), Judgement::fail);
  const auto said = conclusions(cycle);
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(said[0], "1 of 20 laps failed, the first one 35 s after the start:");
  EXPECT_EQ(said[1], "Canard 3 is slow: it is.");
}

TEST(Cycle, WithoutABatteryVoltageThereIsNoColumnForIt) {
  Cycle cycle = rising(2);
  for (Lap& lap : cycle.laps) {
    lap.battery_v.reset();
  }
  EXPECT_EQ(cycle_csv(cycle).find("battery"), std::string::npos);
  EXPECT_EQ(cycle_text(cycle).find("battery, V"), std::string::npos);
  EXPECT_EQ(json::parse(cycle_json(cycle))["battery_v"].dump(), "null");
  EXPECT_EQ(conclusions(cycle).back(), "The avionics does not report a battery voltage, so none is shown.");
}

TEST(Cycle, ANameFromAFileDoesNotCommandTheTerminal) {
  Cycle cycle = rising(2);
  cycle.heading.vehicle = "a\x1b[2J\nb";
  EXPECT_NE(cycle_text(cycle).find("  vehicle   a?[2J?b\n"), std::string::npos);
}

// Against the record itself: a canard that stands off by a quarter of a degree has that error in every tick.
TEST(Cycle, TheErrorOfALapIsThatOfTheRamps) {
  const Exercise lap = Exercise::limits_together(six_degrees());
  EXPECT_NEAR(lap.duration_s(), 4.4, 1e-9);
  ASSERT_EQ(lap.turns().size(), 1U);
  Bench bench;
  for (auto& canard : bench.canards) {
    canard.lag_s = 0.02;
  }
  bench.canards[1].offset_rad = 0.25 * degree;
  const Lap measured = lap_of(examine(bench.record(lap), lap, {}, {}));
  ASSERT_TRUE(measured.measured()) << measured.doubt;
  EXPECT_NEAR(text::degrees(*measured.canards[1].tracking_rms_rad), 0.25, 0.01);
  EXPECT_NEAR(text::degrees(*measured.canards[1].tracking_error_rad), 0.25, 0.02);
  EXPECT_LT(text::degrees(*measured.canards[0].tracking_rms_rad), 0.02);
  EXPECT_NEAR(*measured.canards[0].lag_s, 0.021, 0.001);
}

double asked_deg(const Exercise& exercise, std::size_t canard, double time_s) {
  return static_cast<double>(exercise.asked(time_s)[canard].value().degrees());
}

// Settle 0.4; four ramps of (6 + 3) deg at 20 deg/s; four holds of 0.3; steps 0.3, 0.4 and 0.3: 4.4 s, five times.
TEST(Exercise, LimitsOfSixDegreesTakeTwentyTwoSeconds) {
  EXPECT_NEAR(Exercise::limits(six_degrees()).duration_s(), 22.0, 1e-9);
  EXPECT_NEAR(Exercise::limits_of(six_degrees(), 2).duration_s(), 4.4, 1e-9);
}

TEST(Exercise, EachCanardHasItsTurnAloneAndThenAllMoveTogether) {
  const Exercise exercise = Exercise::limits(six_degrees());
  for (int turn = 0; turn < 5; ++turn) {
    const auto asked = exercise.asked(4.4 * turn + 1.0);
    for (int canard = 0; canard < 4; ++canard) {
      EXPECT_EQ(asked[static_cast<std::size_t>(canard)].has_value(), turn == 4 || turn == canard);
    }
  }
}

TEST(Exercise, ACanardIsAskedThreeDegreesBeyondItsLimitAndNeverMoreThanTheBusCarries) {
  const Exercise six = Exercise::limits(six_degrees());
  EXPECT_NEAR(asked_deg(six, 0, 1.0), 9.0, 1e-5);   // the hold, 0.85 to 1.15 s
  EXPECT_NEAR(asked_deg(six, 0, 2.5), -9.0, 1e-5);  // 2.35 to 2.65 s
  const Exercise twenty = Exercise::limits(six_degrees(20.0));
  double largest = 0.0;
  for (int t = 0; t < 40'000; ++t) {
    for (const auto& angle : twenty.asked(0.001 * t)) {
      largest = std::max(largest, std::abs(angle ? static_cast<double>(angle->degrees()) : 0.0));
    }
  }
  EXPECT_NEAR(largest, 20.47, 1e-5);
}

TEST(Exercise, RampsGoAtTwentyDegreesASecondAndStepsAtOnce) {
  const Exercise exercise = Exercise::limits(six_degrees());
  EXPECT_NEAR(asked_deg(exercise, 0, 0.6) - asked_deg(exercise, 0, 0.5), 2.0, 1e-4);
  EXPECT_NEAR(asked_deg(exercise, 0, 3.399), 0.0, 1e-5);
  EXPECT_NEAR(asked_deg(exercise, 0, 3.401), 6.0, 1e-5);
  EXPECT_NEAR(asked_deg(exercise, 0, 3.701), -6.0, 1e-5);
  EXPECT_NEAR(asked_deg(exercise, 0, 4.101), 0.0, 1e-5);
}

TEST(Exercise, BeginsAndEndsAtTheCentreHoweverEarlyOrLateItIsRead) {
  const Exercise exercise = Exercise::limits(six_degrees(6.0, -1.25));
  for (const double time_s : {-5.0, 0.0, 1e6}) {
    for (const auto& angle : exercise.asked(time_s)) {
      EXPECT_NEAR(angle ? static_cast<double>(angle->degrees()) : -1.25, -1.25, 1e-5);
    }
  }
}

TEST(Exercise, CanardsWithDifferentLimitsArriveTogether) {
  Bounds bounds = six_degrees();
  bounds.limit_rad[3] = 3.0 * degree;
  const Exercise exercise = Exercise::limits(bounds);
  const Stretch& ramp = exercise.stretches()[exercise.turns()[4].first + 1];
  EXPECT_EQ(ramp.part, Part::ramp_positive);
  EXPECT_NEAR(asked_deg(exercise, 0, ramp.end_s), 9.0, 1e-4);
  EXPECT_NEAR(asked_deg(exercise, 3, ramp.end_s), 6.0, 1e-4);
}

TEST(Exercise, AStretchBelongsToEveryTime) {
  const Exercise exercise = Exercise::limits(six_degrees());
  EXPECT_EQ(exercise.stretch_at(-1.0), 0U);
  EXPECT_EQ(exercise.stretch_at(1e9), exercise.stretches().size() - 1);
  for (std::size_t i = 0; i < exercise.stretches().size(); ++i) {
    const Stretch& stretch = exercise.stretches()[i];
    EXPECT_EQ(exercise.stretch_at(0.5 * (stretch.begin_s + stretch.end_s)), i);
  }
}

TEST(Exercise, ItsFirstTurnsAreAnExerciseThatEndsWithThem) {
  const Exercise whole = Exercise::limits(six_degrees());
  const Exercise two = whole.beginning(2);
  EXPECT_NEAR(two.duration_s(), 8.8, 1e-9);
  EXPECT_EQ(two.turns().size(), 2U);
  EXPECT_NEAR(asked_deg(two, 1, 4.4 + 1.0), 9.0, 1e-5);
  EXPECT_THROW((void)whole.beginning(0), std::invalid_argument);
  EXPECT_THROW((void)whole.beginning(6), std::invalid_argument);
  EXPECT_EQ(whole.turns_before(whole.stretch_at(8.7)), 1U);
  EXPECT_EQ(whole.turns_before(whole.stretch_at(8.9)), 2U);
}

TEST(Exercise, SaysWhatItDoes) {
  const Exercise exercise = Exercise::limits(six_degrees());
  const auto doing = [&](double time_s) { return exercise.doing(exercise.stretch_at(time_s)); };
  EXPECT_EQ(doing(0.1), "canard 1 alone: at the centre");
  EXPECT_EQ(doing(4.4 + 1.0), "canard 2 alone: held beyond the + limit");
  EXPECT_EQ(doing(4.0 * 4.4 + 2.5), "all four together: held beyond the \u2212 limit");
  EXPECT_EQ(doing(1e6), "all four together: at once to the centre");
}

TEST(Exercise, ASineSwingsAboutTheCentreOfOneCanard) {
  const Exercise exercise =
      Exercise::sine(six_degrees(6.0, 1.0), 1, {.amplitude_rad = 4.0 * degree, .frequency_hz = 2.0, .cycles = 3});
  EXPECT_NEAR(exercise.duration_s(), 0.4 + 1.5 + 0.4, 1e-9);
  EXPECT_NEAR(asked_deg(exercise, 1, 0.4 + 0.125), 5.0, 1e-4);
  EXPECT_NEAR(asked_deg(exercise, 1, 0.4 + 0.375), -3.0, 1e-4);
  EXPECT_FALSE(exercise.asked(0.5)[0]);
}

TEST(Exercise, RefusesWhatCannotBeAsked) {
  const Bounds b = six_degrees();
  EXPECT_THROW((void)Exercise::step(b, 0, 21.0 * degree), std::invalid_argument);
  EXPECT_THROW((void)Exercise::step(b, 4, 1.0 * degree), std::invalid_argument);
  EXPECT_THROW((void)Exercise::step(b, 0, std::nan("")), std::invalid_argument);
  EXPECT_THROW((void)Exercise::sine(b, 0, {.amplitude_rad = 0.1, .frequency_hz = 0.0, .cycles = 1}),
               std::invalid_argument);
  EXPECT_THROW((void)Exercise::sine(b, 0, {.amplitude_rad = 0.1, .frequency_hz = 1.0, .cycles = 61}),
               std::invalid_argument);
  EXPECT_THROW((void)Exercise::sine(b, 0, {.amplitude_rad = 0.1, .frequency_hz = 50.0, .cycles = 4}),
               std::invalid_argument);
  EXPECT_THROW((void)Exercise::sine(b, 0, {.amplitude_rad = 0.1, .frequency_hz = 1.0, .cycles = 0}),
               std::invalid_argument);
}

TEST(Exercise, ATrimBeyondTheLimitStandsAtIt) {
  protocol::LimitReport report;
  report.limit.fill(core::Angle::from_degrees(2.0F));
  Each<core::Angle> trims{};
  trims[1] = core::Angle::from_degrees(-3.0F);
  const Bounds b = bounds(report, trims);
  EXPECT_NEAR(b.centre_rad[1] / degree, -2.0, 1e-5);
  EXPECT_NEAR(b.centre_rad[0] / degree, 0.0, 1e-5);
}

TEST(Exercise, OneCanardAloneIsAdvisedOnlyToAPcThatKeptUpForSoLong) {
  const Exercise all = Exercise::limits(six_degrees());
  EXPECT_EQ(advice(all, 20.0), ". One canard alone, with --canard N, takes 4.4 s; this PC kept up for 20.0 s");
  EXPECT_EQ(advice(all, 4.3), "");
  EXPECT_EQ(advice(all, all.duration_s()), "");
  EXPECT_EQ(advice(Exercise::limits_of(six_degrees(), 1), 4.0), "");
  EXPECT_EQ(advice(Exercise::step(six_degrees(), 1, 0.1), 1.0), "");
}

}  // namespace

}  // namespace fantail::bench
