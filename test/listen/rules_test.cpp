// SPDX-License-Identifier: MIT
// Lift-off, ends of ranges and the log's own apogee: rules that know nothing of the law.
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "listen/lift_off.hpp"
#include "listen/range_end.hpp"
#include "listen/sensors.hpp"
#include "seed.hpp"

namespace fantail::listen {
namespace {

constexpr double g = 9.80665;

Signal signal(double end_s, double interval_s, const std::function<double(double)>& value) {
  Signal made{.words = "a"};
  for (int i = 0; i * interval_s <= end_s; ++i) {
    made.time_s.push_back(i * interval_s);
    made.value.push_back(value(i * interval_s));
  }
  return made;
}

std::optional<double> lift_off_s(const Signal& axial) {
  const std::vector<double> all = lift_offs_s(axial);
  return all.empty() ? std::nullopt : std::optional{all[0]};
}

TEST(LiftOff, IsWhereTheLineBetweenTwoSamplesCrossesTwoG) {
  // From 1 g at 1.0 s to 6 g at 1.1 s: 2 g a fifth of the way.
  const Signal axial = signal(3.0, 0.1, [](double t) { return t < 1.05 ? g : 6.0 * g; });
  EXPECT_NEAR(lift_off_s(axial).value(), 1.02, 1e-6);
}

TEST(LiftOff, IsNoKnock) {
  const auto knock = [](double width_s) {
    return signal(5.0, 0.01, [=](double t) { return t > 1.0 && t < 1.0 + width_s ? 20.0 * g : t > 3.0 ? 5.0 * g : g; });
  };
  EXPECT_NEAR(lift_off_s(knock(0.14)).value(), 3.0, 0.011);
  EXPECT_NEAR(lift_off_s(knock(0.17)).value(), 1.0, 0.011) << "more than half of 0.3 s counts";
}

// 3 g above that of the pad for 0.25 s are 7 m/s, which a hand gives; a boost of 1.5 s begins two seconds later.
TEST(LiftOff, IsNoBumpThatLastsUnlessItIsTheBeginningOfAFlight) {
  const auto bump = [](double launch_s) {
    return signal(6.0, 0.01, [=](double t) {
      return t > 1.0 && t < 1.25 ? 4.0 * g : t > launch_s && t < launch_s + 1.5 ? 8.0 * g : t > launch_s ? -g : g;
    });
  };
  EXPECT_NEAR(lift_off_s(bump(3.0)).value(), 3.0, 0.011);
  EXPECT_NEAR(lift_off_s(bump(1.5)).value(), 1.5, 0.011);
  EXPECT_NEAR(lift_off_s(bump(1.3)).value(), 1.0, 0.011) << "a twentieth of a second apart they are one push";
  EXPECT_EQ(lift_off_s(bump(9.0)), std::nullopt);
}

TEST(LiftOff, IsNoRowOfStrokesOfAHand) {
  const Signal axial = signal(8.0, 0.01, [](double t) {
    return t < 1.0 ? g : std::fmod(t, 0.5) < 0.25 ? 4 * g : -2 * g;
  });
  EXPECT_EQ(lift_off_s(axial), std::nullopt);
}

TEST(LiftOff, OfALogThatEndsInThePushIsItsBeginning) {
  const Signal axial = signal(1.2, 0.01, [](double t) { return t < 1.0 ? g : 5.0 * g; });
  EXPECT_NEAR(lift_off_s(axial).value(), 1.0, 0.011);
}

// 4 g more than the pad for 2 s, and again 20 s later; between them 0.25 s of the same, which a parachute may give.
TEST(LiftOff, OfEachPushThatMakesAFlightIsFoundOnceAndOfNoOther) {
  const auto in = [](double t, double from, double long_s) { return t > from && t < from + long_s; };
  const Signal axial = signal(40.0, 0.01, [&](double t) {
    return in(t, 5.0, 2.0) || in(t, 12.0, 0.25) || in(t, 25.0, 2.0) ? (std::fmod(t, 0.1) < 0.05 ? 6.0 : 1.8) * g : g;
  });
  const std::vector<double> all = lift_offs_s(axial);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NEAR(all[0], 5.0, 0.011);
  EXPECT_NEAR(all[1], 25.0, 0.011);
}

TEST(LiftOff, ThatShakesThroughTwoGIsTheFirstCrossing) {
  // 40 ms above, 20 ms below: two thirds of the time.
  const Signal axial = signal(3.0, 0.01, [](double t) { return t < 1.0 ? g : std::fmod(t, 0.06) < 0.04 ? 6 * g : g; });
  EXPECT_NEAR(lift_off_s(axial).value(), 1.0, 0.021);
}

TEST(LiftOff, IsTheFirstSampleOfALogThatBeginsInThrustAndNoneOfOneAtRest) {
  EXPECT_EQ(lift_off_s(signal(1.0, 0.01, [](double) { return 5.0 * g; })), 0.0);
  EXPECT_EQ(lift_off_s(signal(1.0, 0.01, [](double) { return g; })), std::nullopt);
}

TEST(LiftOff, OfAnAccelerometerThatEndsBelowTwoGIsWhereItReachesItsEnd) {
  std::mt19937 random{test::seed()};
  std::normal_distribution<double> noise{0.0, 0.05};
  const Signal axial =
      signal(3.0, 0.01, [&](double t) { return std::min(19.6, (t < 1.0 ? g : 5.0 * g) + noise(random)); });
  EXPECT_NEAR(lift_off_s(axial).value(), 1.0, 0.011);
  const Signal bump =
      signal(3.0, 0.01, [&](double t) { return std::min(19.6, (t < 1.0 || t > 1.25 ? g : 5.0 * g) + noise(random)); });
  EXPECT_EQ(lift_off_s(bump), std::nullopt) << "a quarter of a second at the end";
}

struct Noise {
  std::mt19937 random{test::seed()};
  std::normal_distribution<double> draw{0.0, 0.5};
  double operator()() { return draw(random); }
};

TEST(RangeEnd, IsWhereReadingsOfANoisySignalRepeatAtTheTop) {
  Noise noise;
  const Signal axial =
      signal(4.0, 0.01, [&](double t) { return std::min(156.9, (t > 1.0 && t < 2.0 ? 20.0 : 3.0) * g + noise()); });
  const auto end = range_end(axial, Side::positive);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->value, 156.9);
  EXPECT_NEAR(static_cast<double>(end->samples), 99.0, 1.0);
  EXPECT_NEAR(end->first_s, 1.01, 0.011);
  EXPECT_NEAR(end->longest_s, 0.98, 0.011);
  EXPECT_TRUE(end->holds(156.9));
  EXPECT_FALSE(end->holds(156.0));
  EXPECT_FALSE(end->holds(-156.9));
  EXPECT_EQ(range_end(axial, Side::negative), std::nullopt);
}

TEST(RangeEnd, OfTheOtherSideIsFoundAlike) {
  Noise noise;
  const Signal rate = signal(4.0, 0.01, [&](double t) { return std::max(-34.9, -60.0 * std::sin(t) + noise()); });
  EXPECT_EQ(range_end(rate, Side::negative)->value, -34.9);
  EXPECT_EQ(range_end(rate, Side::positive), std::nullopt);
}

TEST(RangeEnd, IsNoPeakAndNoHeldSampleAndNothingOfALogWithoutNoise) {
  Noise noise;
  EXPECT_EQ(range_end(signal(4.0, 0.01, [&](double t) { return 60.0 * std::sin(t) + noise(); }), Side::positive),
            std::nullopt);
  // A sensor of 25 Hz in a log of 100 Hz: each reading stands four times.
  double held = 0.0;
  int count = 0;
  const Signal slow = signal(4.0, 0.01, [&](double t) {
    held = count++ % 4 == 0 ? 60.0 * std::sin(t) + noise() : held;
    return held;
  });
  EXPECT_EQ(range_end(slow, Side::positive), std::nullopt);
  EXPECT_EQ(range_end(signal(4.0, 0.01, [](double t) { return t < 1.0 ? g : 5.0 * g; }), Side::positive), std::nullopt);
  EXPECT_EQ(range_end(Signal{}, Side::positive), std::nullopt);
}

// From 1 g on by 20 m/s2 a second from 2 s on: 60 m/s2 are reached at 4.51 s, and the first sample there is at 4.6 s.
TEST(Channel, OfARampIsAtTheEndOfItsRangeFromItsFirstSampleThereOnAndNotBefore) {
  const Signal ramp = signal(9.0, 0.2, [](double t) {
    return t < 2.1 ? g + 0.01 * t : t < 8.1 ? std::min(60.0, g + 20.0 * (t - 2.0)) : 0.0;
  });
  Channel channel{ramp, 2.0, 0.0};
  for (int i = 0; i < 9000; ++i) {
    const double t = 1e-3 * i + 5e-4;
    const Channel::Sample sample = channel.at(t).value();
    EXPECT_EQ(sample.at_positive_end, t > 4.6 && t < 8.0) << t;
    EXPECT_TRUE(t < 2.2 || t > 4.4 || std::abs(sample.value - (g + 20.0 * (t - 2.0))) < 1e-9) << t;
    EXPECT_FALSE(sample.at_negative_end);
  }
}

TEST(LogHeight, CountsFromThePadAndHasItsApogeeWhereTheMedianIsLargest) {
  const Signal height = signal(20.0, 0.05, [](double t) {
    const double flown = t < 3.0 ? 0.0 : 100.0 * (t - 3.0) - 5.0 * (t - 3.0) * (t - 3.0);
    return 1400.0 + flown + (std::abs(t - 6.0) < 0.1 ? 900.0 : 0.0);  // a spike: 4 samples of 10
  });
  const LogHeight result = log_height(height, 3.0);
  EXPECT_NEAR(result.apogee_s.value(), 13.0, 0.051);
  EXPECT_NEAR(result.apogee_m, 500.0, 0.5);
  EXPECT_NEAR(result.above_pad.value.front(), 0.0, 1e-9);
}

TEST(LogHeight, ThatStillRisesHasNoApogee) {
  EXPECT_EQ(log_height(signal(5.0, 0.05, [](double t) { return 10.0 * t; }), 1.0).apogee_s, std::nullopt);
  EXPECT_EQ(log_height(Signal{}, 1.0).apogee_s, std::nullopt);
  // Two flights of the same height: the first one's.
  const Signal twice =
      signal(60.0, 0.05, [](double t) { return std::max(0.0, 100.0 - 4.0 * std::pow(std::fmod(t, 30.0) - 10.0, 2)); });
  EXPECT_NEAR(log_height(twice, 6.0).apogee_s.value(), 10.0, 0.03);
  const Signal higher = signal(
      60.0, 0.05, [](double t) { return t < 30.0 ? std::max(0.0, 100.0 - 4.0 * (t - 10.0) * (t - 10.0)) : 300.0; });
  EXPECT_NEAR(log_height(higher, 6.0, 29.0).apogee_s.value(), 10.0, 0.03);
}

}  // namespace
}  // namespace fantail::listen
