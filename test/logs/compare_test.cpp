// SPDX-License-Identifier: MIT
#include "logs/compare.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "logs/refused.hpp"
#include "seed.hpp"

namespace fantail::logs {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

struct Clock {
  double begin_s;
  double end_s;
  double interval_s;
};

// phi(t) = a sin(2 pi f t), its rate, and how far B's clock is ahead.
RollLog sine(const Clock& clock, double ahead_s = 0.0, double offset_rad = 0.0, double hertz = 0.5) {
  RollLog log;
  log.name = "log";
  const auto count = static_cast<int>(std::lround((clock.end_s - clock.begin_s) / clock.interval_s));
  for (int i = 0; i <= count; ++i) {
    const double t = clock.begin_s + i * clock.interval_s;
    log.time_s.push_back(t);
    log.roll_angle_rad.push_back(offset_rad + std::sin(turn * hertz * (t - ahead_s)));
    log.roll_rate_rad_s.push_back(turn * hertz * std::cos(turn * hertz * (t - ahead_s)));
  }
  return log;
}

// phi = angle + rate t: B in between is exact.
RollLog line(const Clock& clock, double angle_rad, double rate_rad_s) {
  RollLog log = sine(clock);
  for (std::size_t i = 0; i < log.time_s.size(); ++i) {
    log.roll_angle_rad[i] = angle_rad + rate_rad_s * log.time_s[i];
    log.roll_rate_rad_s[i] = rate_rad_s;
  }
  return log;
}

TEST(Compare, ALogDiffersFromItselfByNothing) {
  const RollLog log = sine({0, 5, 0.01});
  const Comparison result = compare(log, log, {});
  EXPECT_EQ(result.time_s, log.time_s);
  EXPECT_EQ(result.angle.max_abs, 0.0);
  EXPECT_EQ(result.rate.rms, 0.0);
  EXPECT_TRUE(result.warnings.empty());
}

TEST(Compare, AConstantOffsetIsMeanRmsAndMaximum) {
  RollLog b = line({0, 5, 0.007}, 0.5, 1.0);
  for (double& rate_rad_s : b.roll_rate_rad_s) {
    rate_rad_s += 0.5;
  }
  const Comparison result = compare(line({0, 5, 0.01}, 0.25, 1.0), b, {});
  EXPECT_NEAR(result.angle.mean_abs, 0.25, 1e-12);
  EXPECT_NEAR(result.angle.rms, 0.25, 1e-12);
  EXPECT_NEAR(result.angle.max_abs, 0.25, 1e-12);
  EXPECT_NEAR(result.angle_difference_rad[0], -0.25, 1e-12);
  EXPECT_NEAR(result.rate.mean_abs, 0.5, 1e-12);
}

// A - B = 0.5 t over 0..4 s: mean 1, rms 2/sqrt(3), largest 2 at 4 s.
TEST(Compare, ADifferenceThatGrowsHasTheMeanRmsAndMaximumOfARamp) {
  const Comparison result = compare(line({0, 5, 0.001}, 0.0, 1.5), line({-1, 6, 0.013}, 0.0, 1.0), {.to_s = 4.0});
  EXPECT_NEAR(result.angle.mean_abs, 1.0, 1e-9);
  EXPECT_NEAR(result.angle.rms, 2.0 / std::sqrt(3.0), 2e-4);  // 4001 samples for the integral
  EXPECT_NEAR(result.angle.max_abs, 2.0, 1e-9);
  EXPECT_NEAR(result.angle.max_at_s, 4.0, 1e-9);
  EXPECT_NEAR(result.rate.mean_abs, 0.5, 1e-12);
}

TEST(Compare, BIsNeverExtrapolated) {
  const Comparison result = compare(line({0, 10, 0.1}, 0, 1), line({2.05, 7.05, 0.05}, 0, 1), {});
  EXPECT_NEAR(result.time_s.front(), 2.1, 1e-9);
  EXPECT_NEAR(result.time_s.back(), 7.0, 1e-9);
  EXPECT_EQ(result.time_s.size(), 50U);
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_NE(result.warnings[0].find("51 of the 101 samples"), std::string::npos) << result.warnings[0];
}

TEST(Compare, BIsNeverTakenAcrossAGap) {
  RollLog b = line({0, 10, 0.05}, 0, 1);
  for (auto* column : {&b.time_s, &b.roll_angle_rad, &b.roll_rate_rad_s}) {
    column->erase(column->begin() + 41, column->begin() + 60);  // 2.05 s to 2.95 s
  }
  const Comparison result = compare(line({0, 10, 0.01}, 0, 1), b, {});
  for (const double t : result.time_s) {
    EXPECT_FALSE(t > 2.0 + 1e-9 && t < 3.0 - 1e-9) << t;
  }
  EXPECT_GE(result.time_s.size(), 1001U - 99U - 2U);
}

TEST(Compare, WhereAHasNoSamplesIsSaid) {
  RollLog a = line({0, 10, 0.01}, 0, 1);
  for (auto* column : {&a.time_s, &a.roll_angle_rad, &a.roll_rate_rad_s}) {
    column->erase(column->begin() + 601, column->begin() + 650);
    column->erase(column->begin() + 201, column->begin() + 300);
  }
  const RollLog b = line({0, 10, 0.01}, 0, 1);
  EXPECT_EQ(compare(a, b, {}).warnings,
            std::vector<std::string>{"log has no samples between 2.000 s and 3.000 s, nor in 1 more gap: nothing is "
                                     "compared there."});
  EXPECT_EQ(compare(a, b, {.from_s = 5.0}).warnings,
            std::vector<std::string>{"log has no samples between 6.000 s and 6.500 s: nothing is compared there."});
  EXPECT_TRUE(compare(a, b, {.from_s = 7.0}).warnings.empty());
  EXPECT_TRUE(compare(line({0, 10, 0.2}, 0, 1), b, {}).warnings.empty());  // they are all so far apart
}

TEST(Compare, ALogOfTenSamplesASecondHasNoGaps) {
  EXPECT_EQ(compare(line({0, 9, 0.01}, 0, 1), line({0, 9, 0.1}, 0, 1), {}).time_s.size(), 901U);
}

TEST(Compare, AStatedShiftIsTakenFromBsClock) {
  const Comparison result = compare(line({0, 5, 0.01}, 0, 1), line({1, 8, 0.01}, -1.5, 1), {.shift_s = 1.5});
  EXPECT_NEAR(result.angle.max_abs, 0.0, 1e-12);
  EXPECT_EQ(result.shift_s, 1.5);
}

TEST(Compare, DifferentZerosOfTheAngleCanBeTakenOff) {
  const RollLog a = sine({0, 5, 0.01});
  const RollLog b = sine({0, 5, 0.01}, 0.0, 3.0);
  EXPECT_NEAR(compare(a, b, {}).angle.mean_abs, 3.0, 1e-12);
  const Comparison result = compare(a, b, {.from_s = 1.0, .remove_offset = true});
  EXPECT_NEAR(result.offset_rad, -3.0, 1e-12);
  EXPECT_NEAR(result.angle.max_abs, 0.0, 1e-12);
}

class CompareShift : public testing::TestWithParam<double> {};

TEST_P(CompareShift, IsFoundWithinAMillisecond) {
  for (const double interval : {0.001, 0.01, 0.013, 0.02}) {
    for (const double ahead : {0.037, -0.037, 0.5, -1.2345}) {
      const RollLog a = sine({0, 10, GetParam()}, 0.0, 0.0, 0.23);
      const RollLog b = sine({-3.0031, 13, interval}, ahead, 0.0, 0.23);
      const Comparison result = compare(a, b, {.find_shift = true});
      EXPECT_NEAR(result.shift_s, ahead, 1e-3) << interval;
      EXPECT_LT(result.rate.rms, 3e-3);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AtIntervals, CompareShift, testing::Values(0.001, 0.01, 0.02),
                         [](const auto& one) { return "Number" + std::to_string(one.index); });

// Where B is read between two samples its noise is halved, which makes such shifts look better than they are. The mean
// of many draws shows a bias and not chance.
TEST(Compare, NoiseDoesNotPullTheShiftToTheMiddleOfASample) {
  std::mt19937 random{test::seed(11)};
  std::normal_distribution<double> noise{0.0, 0.05};
  for (const double ahead : {0.0, 0.003, 0.005, 0.0075}) {
    double sum = 0.0;
    constexpr int draws = 40;
    for (int draw = 0; draw < draws; ++draw) {
      RollLog a = sine({0, 8, 0.01}, 0.0, 0.0, 0.23);
      RollLog b = sine({-3, 11, 0.01}, ahead, 0.0, 0.23);
      for (double& rate : a.roll_rate_rad_s) {
        rate += noise(random);
      }
      for (double& rate : b.roll_rate_rad_s) {
        rate += noise(random);
      }
      sum += compare(a, b, {.find_shift = true}).shift_s;
    }
    // The best anybody can do with one draw is sqrt(2) 0.05 / sqrt(800) / (2.09 rad/s2 / sqrt(2)) = 1.7 ms.
    EXPECT_NEAR(sum / draws, ahead, 6.0 * 1.7e-3 / std::sqrt(draws)) << ahead;
  }
}

TEST(Compare, AShiftBeyondTheSearchIsSaidToBeAtItsEdge) {
  // A single swing, 3 s later in B: every step towards it agrees better.
  RollLog a = sine({0, 20, 0.01});
  RollLog b = a;
  for (std::size_t i = 0; i < a.time_s.size(); ++i) {
    const double t = a.time_s[i] - 8.0;
    a.roll_rate_rad_s[i] = std::exp(-t * t / 8.0);
    b.roll_rate_rad_s[i] = std::exp(-(t - 3.0) * (t - 3.0) / 8.0);
  }
  const Comparison result = compare(a, b, {.find_shift = true});
  EXPECT_NEAR(result.shift_s, 2.0, 1e-9);
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_NE(result.warnings[0].find("end of the search range"), std::string::npos);
}

// Two swings a second apart, 3 s later in B: within 2 s the second meets the first, which is not the shift.
TEST(Compare, AShiftThatLeavesMuchOfTheMotionIsDoubted) {
  RollLog a = sine({0, 20, 0.01});
  RollLog b = a;
  const auto swings = [](double t) { return std::exp(-8.0 * t * t) + 2.0 * std::exp(-8.0 * (t - 1.2) * (t - 1.2)); };
  for (std::size_t i = 0; i < a.time_s.size(); ++i) {
    a.roll_rate_rad_s[i] = swings(a.time_s[i] - 8.0);
    b.roll_rate_rad_s[i] = swings(a.time_s[i] - 11.0);
  }
  const auto doubts = [](const Comparison& comparison) {
    return std::ranges::count_if(comparison.warnings, [](const std::string& warning) {
      return warning.find("the clocks differ by more") != std::string::npos;
    });
  };
  EXPECT_EQ(doubts(compare(a, b, {.find_shift = true})), 1);
  const Comparison right = compare(a, b, {.find_shift = true, .most_shift_s = 4.0});
  EXPECT_NEAR(right.shift_s, 3.0, 1e-3);
  EXPECT_EQ(doubts(right), 0);
}

TEST(Compare, LogsWithoutOverlapAreRefused) {
  test::expect_refused(text::ErrorKind::bad_data, {"no overlap", "0 s to 5 s", "6 s to 9 s"},
                       [] { (void)compare(sine({0, 5, 0.01}), sine({6, 9, 0.01}), {}); });
  test::expect_refused(text::ErrorKind::bad_data, {"no overlap", "at most 0.1 s apart"},
                       [] { (void)compare(sine({0.1, 5, 0.5}), sine({0, 9, 0.25}), {}); });
  test::expect_refused(text::ErrorKind::bad_data, {"do not overlap"},
                       [] { (void)compare(sine({0, 5, 0.01}), sine({20, 25, 0.01}), {.find_shift = true}); });
}

TEST(Compare, OneSampleIsTooFew) {
  test::expect_refused(text::ErrorKind::bad_data, {"there is only one sample to compare, at 5 s of log"},
                       [] { (void)compare(sine({0, 5, 0.01}), sine({5, 9, 0.01}), {}); });
}

TEST(Compare, ASteadyRateCannotBeAligned) {
  test::expect_refused(text::ErrorKind::bad_data, {"rates do not change"}, [] {
    (void)compare(line({0, 5, 0.01}, 0, 1), line({-3, 8, 0.01}, 0, 2), {.find_shift = true});
  });
}

// With the usual interval of A sought anew for each of its samples this took an hour.
TEST(Compare, OfAQuarterOfAMillionSamplesIsReadyAtOnce) {
  const RollLog log = sine({0, 250, 0.001});
  EXPECT_EQ(compare(log, log, {}).angle.max_abs, 0.0);
}

TEST(Compare, WindowsOutsideTheDataAreRefused) {
  const RollLog log = sine({0, 5, 0.01});
  test::expect_refused(text::ErrorKind::bad_data, {"window 7 s to 8 s", "0 s to 5 s"},
                       [&] { (void)compare(log, log, {.from_s = 7.0, .to_s = 8.0}); });
  test::expect_refused(text::ErrorKind::bad_configuration, {"begins at 3 s, after its end at 2 s"},
                       [&] { (void)compare(log, log, {.from_s = 3.0, .to_s = 2.0}); });
}

}  // namespace
}  // namespace fantail::logs
