// SPDX-License-Identifier: MIT
#include "tunnel/steady.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "logs/refused.hpp"
#include "tunnel/made_logs.hpp"

namespace fantail::tunnel {
namespace {

constexpr double of_tenths = 0.1 / 3.4641016151377544;  // a tenth over the root of twelve

// 1000 rpm, from 100 s on 1500 rpm, 0.02 m/s per rpm, with a lag of the air.
TunnelLog two_set_points(double lag_s, double end_s) {
  return made_tunnel_log(
      end_s, [](double t) { return t < 100.0 ? 1000.0 : 1500.0; },
      [lag_s](double t) { return to_tenths(t < 100.0 ? 20.0 : 30.0 - 10.0 * std::exp(-(t - 100.0) / lag_s)); });
}

// Left of a change D after t: D exp(-t / T), a quarter of the rounding's 0.0289 m/s after T ln(D / 0.0072).
TEST(SettledFrom, IsWhereAQuarterOfTheScatterIsLeftAlthoughRoundingHidesIt) {
  const double lag_s = 12.0;
  std::vector<double> time_s;
  std::vector<double> speed_m_s;
  for (int i = 0; i < 100; ++i) {
    time_s.push_back(2.0 * i);
    speed_m_s.push_back(to_tenths(22.0 - 10.0 * std::exp(-2.0 * i / lag_s)));
  }
  const double expected_s = lag_s * std::log(10.0 / (0.25 * of_tenths));
  EXPECT_NEAR(time_s[settled_from(time_s, speed_m_s, of_tenths)], expected_s, 0.6 * lag_s);
}

TEST(SettledFrom, WithoutScatterFollowsAnExponentialToItsEnd) {
  std::vector<double> time_s;
  std::vector<double> value;
  for (int i = 0; i <= 100; ++i) {
    time_s.push_back(i);
    value.push_back(5.0 + 8.0 * std::exp(-i / 7.0));
  }
  EXPECT_NEAR(time_s[settled_from(time_s, value, 0.04)], 7.0 * std::log(8.0 / 0.01), 3.0);
}

TEST(SettledFrom, WhatIsSteadyFromTheStartIsTakenFromTheStart) {
  const std::vector<double> time_s{0.0, 2.0, 4.0, 6.0, 8.0, 10.0};
  EXPECT_EQ(settled_from(time_s, std::vector<double>{22.0, 22.0, 22.0, 22.0, 22.0, 22.0}, of_tenths), 0U);
  EXPECT_EQ(settled_from(time_s, std::vector<double>{22.0, 22.1, 21.9, 22.0, 22.1, 22.0}, of_tenths), 0U);
}

TEST(SettledFrom, ARampNeverSettles) {
  std::vector<double> time_s;
  std::vector<double> value;
  for (int i = 0; i < 50; ++i) {
    time_s.push_back(2.0 * i);
    value.push_back(10.0 + 0.1 * i);
  }
  EXPECT_EQ(settled_from(time_s, value, of_tenths), time_s.size());
}

TEST(FindSteady, BeginsAnewWithEachSetPointAndWaitsForTheAir) {
  const SteadySegments segments = find_steady(two_set_points(8.0, 220.0), {});
  ASSERT_EQ(segments.found.size(), 2U);
  EXPECT_TRUE(segments.left_out.empty());
  EXPECT_EQ(segments.found[0].fan_rpm, 1000.0);
  EXPECT_EQ(segments.found[0].begin_s, 0.0);
  EXPECT_EQ(segments.found[0].end_s, 98.0);
  EXPECT_EQ(segments.found[0].count, 50U);
  EXPECT_EQ(segments.found[1].fan_rpm, 1500.0);
  EXPECT_NEAR(segments.found[1].begin_s, 100.0 + 8.0 * std::log(10.0 / (0.25 * of_tenths)), 6.0);
  EXPECT_EQ(segments.found[1].end_s, 218.0);
}

TEST(FindSteady, ASetPointThatNeverSettledIsNamedAndLeftOut) {
  const SteadySegments segments = find_steady(two_set_points(60.0, 220.0), {});
  ASSERT_EQ(segments.found.size(), 1U);
  ASSERT_EQ(segments.left_out.size(), 1U);
  EXPECT_NE(segments.left_out[0].find("1500 rpm from 100 to 218 s"), std::string::npos) << segments.left_out[0];
}

TEST(FindSteady, AFanThatStandsIsNoSetPoint) {
  const TunnelLog log = made_tunnel_log(100.0, [](double) { return 0.0; }, [](double) { return 0.0; });
  EXPECT_TRUE(find_steady(log, {}).found.empty());
  EXPECT_TRUE(find_steady(log, {}).left_out.empty());
}

TEST(FindSteady, ATachometerThatWobblesMakesNoNewSetPoint) {
  const TunnelLog log = made_tunnel_log(
      200.0, [](double t) { return (t < 100.0 ? 1000.0 : 1050.0) + 6.0 * std::sin(t); }, [](double) { return 20.0; });
  ASSERT_EQ(find_steady(log, {}).found.size(), 2U);
  EXPECT_NEAR(*find_steady(log, {}).found[1].fan_rpm, 1050.0, 1.0);
  EXPECT_EQ(find_steady(log, {.rpm_tolerance = 100.0}).found.size(), 1U);
}

TEST(TakeSteady, AStretchEndsWithTheFansSetPointTheNextStretchOrWhereItSays) {
  const TunnelLog log = two_set_points(8.0, 220.0);
  const SteadySegments segments =
      take_steady(log, {{.begin_s = 10.0}, {.begin_s = 150.0}, {.begin_s = 180.0, .end_s = 200.0}}, {});
  ASSERT_EQ(segments.found.size(), 3U);
  EXPECT_EQ(segments.found[0].end_s, 98.0);
  EXPECT_EQ(segments.found[1].end_s, 178.0);
  EXPECT_EQ(segments.found[2].end_s, 198.0);
  EXPECT_EQ(segments.found[2].fan_rpm, 1500.0);
}

TEST(TakeSteady, ALogWithoutAFanHasStretchesToo) {
  TunnelLog log = two_set_points(8.0, 220.0);
  log.fan_rpm.clear();
  const SteadySegments segments = take_steady(log, {{.begin_s = 150.0}}, {});
  ASSERT_EQ(segments.found.size(), 1U);
  EXPECT_EQ(segments.found[0].end_s, 218.0);
  EXPECT_FALSE(segments.found[0].fan_rpm.has_value());
}

TEST(TakeSteady, AStretchOutsideTheLogIsRefused) {
  const TunnelLog log = two_set_points(8.0, 220.0);
  for (const NamedStretch stretch : {NamedStretch{.begin_s = 500.0}, NamedStretch{.begin_s = -50.0, .end_s = -10.0}}) {
    test::expect_refused(text::ErrorKind::bad_configuration, {"made.csv", "0 to 218 s"},
                         [&] { (void)take_steady(log, {stretch}, {}); });
  }
}

TEST(ParseStretches, TakesBeginsOrBeginsAndEndsThatIncrease) {
  const auto stretches = parse_stretches("100,230.5:300,390");
  ASSERT_TRUE(stretches.has_value());
  ASSERT_EQ(stretches->size(), 3U);
  EXPECT_EQ((*stretches)[0].begin_s, 100.0);
  EXPECT_FALSE((*stretches)[0].end_s.has_value());
  EXPECT_EQ((*stretches)[1].begin_s, 230.5);
  EXPECT_EQ((*stretches)[1].end_s, 300.0);
  for (const char* wrong : {"", "a", "1,", "1,,2", "2,1", "1,1", "3:2", "1:", ":2", "1:5,4", "nan", "1e999", "1 2"}) {
    EXPECT_FALSE(parse_stretches(wrong).has_value()) << wrong;
  }
}

TEST(RoundingOf, IsTheCoarsestUsualStep) {
  EXPECT_EQ(rounding_of({22.0, 22.1, 0.0, 29.9}), 0.1);
  EXPECT_EQ(rounding_of({22.0, 22.5}), 0.5);
  EXPECT_EQ(rounding_of({9.95, 10.05}), 0.05);
  EXPECT_EQ(rounding_of({22.012}), 0.002);
  EXPECT_EQ(rounding_of({22.0001234}), 0.0);
}

// An anemometer shows whole km/h, or tenths of a mile an hour; the file is read in m/s.
TEST(RoundingOf, IsSeenInTheUnitThatTheSensorShows) {
  EXPECT_DOUBLE_EQ(rounding_of({54.0 / 3.6, 55.0 / 3.6, 53.0 / 3.6}), 1.0 / 3.6);
  EXPECT_DOUBLE_EQ(rounding_of({33.1 * 0.44704, 33.4 * 0.44704}), 0.1 * 0.44704);
  EXPECT_DOUBLE_EQ(rounding_of({40.0 * 1852.0 / 3600.0, 41.0 * 1852.0 / 3600.0}), 1852.0 / 3600.0);
  EXPECT_DOUBLE_EQ(rounding_of({71.5 * 0.3048, 72.0 * 0.3048}), 0.5 * 0.3048);
}

TEST(RoundingDeviation, OfATenthIsThreeHundredths) { EXPECT_NEAR(rounding_deviation(0.1), 0.028868, 1e-6); }

}  // namespace
}  // namespace fantail::tunnel
