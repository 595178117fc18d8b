// SPDX-License-Identifier: MIT
#include "bench/cycle.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "json/value.hpp"
#include "synthetic.hpp"
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
  EXPECT_EQ(conclusions(empty), std::vector<std::string>{"No lap was measured; nothing is said of the canards."});
}

TEST(Cycle, OneLapThatFailedFailsTheRunAndIsNamed) {
  Cycle cycle = rising(20);
  cycle.laps[7].passed = false;
  cycle.laps[7].conclusions = {"Canard 3 is slow: it is."};
  EXPECT_EQ(judgement(cycle), Judgement::fail);
  const auto said = conclusions(cycle);
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(said[0], "1 of 20 laps failed, the first one 35 s after the beginning:");
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
  EXPECT_EQ(conclusions(cycle).back(), "The avionics does not report a battery voltage, so nothing is said of it.");
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

}  // namespace
}  // namespace fantail::bench
