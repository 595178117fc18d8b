// SPDX-License-Identifier: MIT
// Made-up logs whose flight is known in closed form.
#include "listen/fly_log.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/flight_plan_members.hpp"
#include "listen/made_log.hpp"
#include "listen/sentences.hpp"
#include "logs/refused.hpp"
#include "seed.hpp"

namespace fantail::listen {
namespace {

using namespace made;

// Net 4 g for 2 s: 8 g s of speed, 8 g m of height; then free fall: 8 s more to apogee, 32 g m higher. Each straight
// line between samples of 10 ms begins 10 ms before the new value, which moves the push by 5 ms.
TEST(FlyLog, OfAConstantPushHasTheSpeedAndApogeeOfTheClosedForm) {
  const Heard heard = fly_log(log_of(signal(20.0, 0.01, constant_push)), question());
  EXPECT_NEAR(heard.lift_off_s.value(), 4.9925, 1e-6) << "a quarter of the way from 1 g to 5 g";
  EXPECT_EQ(finding(heard), Finding::heard);
  EXPECT_TRUE(heard.doubts.empty()) << heard.doubts[0];
  EXPECT_EQ(figures(headline(heard)).back(), "4.99") << headline(heard);
  // A low-pass of 16 Hz (10 ms) reaches 2.5 g within 15 ms, and the hold is 0.1 s.
  EXPECT_NEAR(heard.since_lift_off_s(heard.detected_s).value(), 0.11, 0.01);
  ASSERT_TRUE(heard.control);
  // 6 m at 4 g net: sqrt(12 / 4 g) after the push began at 4.995.
  EXPECT_NEAR(heard.control->time_s, 4.995 + std::sqrt(12.0 / (4.0 * g)), 0.01);
  EXPECT_NEAR(heard.fastest.value, 8.0 * g, 0.01 * g * 4.0);
  ASSERT_TRUE(heard.apogee_s);
  EXPECT_NEAR(*heard.apogee_s, 4.995 + 10.0, 0.05);
  EXPECT_NEAR(heard.apogee_m, 40.0 * g, 0.005 * 40.0 * g);
  EXPECT_NEAR(heard.tilt_at_apogee_rad, 0.0, 1e-6);
  EXPECT_FALSE(heard.is_lower_bound);
  EXPECT_NEAR(heard.hardest.value, 5.0 * g, 1e-9);
  EXPECT_TRUE(heard.clipped.empty());
  EXPECT_TRUE(says(heard, "interval", {"10", "100"}));
  EXPECT_TRUE(says(heard, "both")) << "of the one accelerometer the law got two";
  EXPECT_EQ(heard.events.front().to, core::Phase::armed);
  EXPECT_EQ(heard.events.back().reason, core::PhaseReason::apogee);
}

TEST(FlyLog, HasAPeakThatASensorCanHaveMeasured) {
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  log.axial.value[550] = 1e39;
  EXPECT_NEAR(fly_log(log, question()).hardest.value, 5.0 * g, 1e-9);
}

TEST(FlyLog, OfATiltedGuideAndAnOffsetGyroTakesBothFromThePad) {
  ImuLog log = log_of(signal(20.0, 0.01, [](double t) { return t < 5.0 ? g * std::cos(0.1) : constant_push(t); }));
  log.lateral_y = signal(20.0, 0.01, [](double t) { return t < 5.0 ? g * std::sin(0.1) : 0.0; });
  log.lateral_z = signal(20.0, 0.01, [](double) { return 0.0; });
  log.pitch_rate = signal(20.0, 0.01, [](double) { return 0.015; });
  const Heard heard = fly_log(std::move(log), question());
  ASSERT_TRUE(heard.apogee_s);
  EXPECT_NEAR(heard.tilt_at_apogee_rad, 0.1, 0.002) << "an offset of 0.015 rad/s would have made 0.175 rad";
  EXPECT_FALSE(says(heard, "upright"));
}

TEST(FlyLog, ThatBeginsAtTheLaunchIsFlownUprightUnlessThePadIsSaid) {
  const auto late = [] {
    ImuLog log =
        log_of(signal(15.0, 0.01, [](double t) { return t < 0.3 ? g * std::cos(0.1) : constant_push(t + 4.7); }));
    log.lateral_y = signal(15.0, 0.01, [](double t) { return t < 0.3 ? g * std::sin(0.1) : 0.0; });
    log.lateral_z = signal(15.0, 0.01, [](double) { return 0.0; });
    return log;
  };
  const Heard upright = fly_log(late(), question());
  EXPECT_TRUE(says(upright, "upright"));
  EXPECT_NEAR(upright.tilt_at_apogee_rad, 0.0, 1e-6);
  Question padded = question();
  padded.pad_s = 5.0;
  const Heard tilted = fly_log(late(), padded);
  EXPECT_NEAR(tilted.tilt_at_apogee_rad, 0.1, 0.002);
  EXPECT_TRUE(says(tilted, "still", {"5"}));
  EXPECT_NEAR(tilted.since_lift_off_s(tilted.detected_s).value(), upright.since_lift_off_s(upright.detected_s).value(),
              0.002);
}

TEST(FlyLog, WithoutGyroHasNoChartOfTiltOrRoll) {
  const std::string without = page_of(fly_log(log_of(signal(20.0, 0.01, constant_push)), question()));
  EXPECT_EQ(without.find("Tilt over time"), std::string::npos);
  EXPECT_EQ(without.find("Roll rate over time"), std::string::npos);
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  log.pitch_rate = log.roll_rate = signal(20.0, 0.01, [](double) { return 0.0; });
  const std::string with = page_of(fly_log(std::move(log), question()));
  EXPECT_NE(with.find("Tilt over time"), std::string::npos);
  EXPECT_NE(with.find("Roll rate over time"), std::string::npos);
}

TEST(FlyLog, TakesTheIntervalThatTheLogHasAroundLiftOff) {
  ImuLog log = log_of(signal(60.0, 0.01, constant_push), 0.01);
  Signal& axial = log.axial;
  Signal thinned{.words = "a"};  // ten samples a second from 10 s after lift-off on
  for (std::size_t i = 0; i < axial.time_s.size(); ++i) {
    if (axial.time_s[i] < 15.0 || i % 10 == 0) {
      thinned.time_s.push_back(axial.time_s[i]);
      thinned.value.push_back(axial.value[i]);
    }
  }
  axial = thinned;
  log.interval_s = 0.1;
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_NEAR(heard.log.interval_s, 0.01, 1e-9);
  EXPECT_NEAR(heard.longest_bridge_s, 0.1, 1e-9);
  EXPECT_TRUE(heard.gaps.empty());
}

TEST(FlyLog, OfAnAxisThatDoesNotReadOneGOnThePadAsksWhetherItIsTheRightOne) {
  const Heard reversed = fly_log(log_of(signal(10.0, 0.01, [](double t) { return -constant_push(t); })), question());
  EXPECT_EQ(finding(reversed), Finding::no_launch);
  const Heard from_rest =
      fly_log(log_of(signal(10.0, 0.01, [](double t) { return constant_push(t) - g; })), question());
  EXPECT_TRUE(doubts(reversed, "axis", {"-1.00", "1"}));
  EXPECT_TRUE(doubts(from_rest, "(axial_from_rest)", {"0.00", "1"}));
  EXPECT_FALSE(doubts(from_rest, "minus") || doubts(from_rest, "twice"));
  EXPECT_FALSE(doubts(fly_log(log_of(signal(10.0, 0.01, constant_push)), question()), "axis"));
}

TEST(FlyLog, AtRestHearsNothing) {
  const Heard heard = fly_log(log_of(signal(10.0, 0.01, [](double) { return g; })), question());
  EXPECT_EQ(finding(heard), Finding::no_launch);
  EXPECT_EQ(heard.events.size(), 1U);
  EXPECT_NE(headline(heard).find("lift-off"), std::string::npos) << headline(heard);
}

// What the law gets across a gap is stale: no hold reaches across it.
TEST(FlyLog, WithAGapInTheHoldIsDetectedAHoldAfterIt) {
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  const auto in_gap = [](double t) { return t > 5.03 && t < 5.499; };
  for (std::size_t i = log.axial.time_s.size(); i-- > 0;) {
    if (in_gap(log.axial.time_s[i])) {
      log.axial.time_s.erase(log.axial.time_s.begin() + static_cast<std::ptrdiff_t>(i));
      log.axial.value.erase(log.axial.value.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  const Heard heard = fly_log(std::move(log), question());
  ASSERT_EQ(heard.gaps.size(), 1U);
  EXPECT_NEAR(heard.detected_s.value(), 5.60, 0.003);
  EXPECT_TRUE(says(heard, "gap", {"100", "5"})) << "what is bridged, and when samples are stale";
}

TEST(FlyLog, OfAnAccelerometerAtTheEndOfItsRangeSaysThatItsFiguresAreLowerBounds) {
  std::mt19937 random{test::seed()};
  std::normal_distribution<double> noise{0.0, 0.3};
  const Signal truth = signal(60.0, 0.01, [&](double t) {
    return (t < 5.0 ? g : t < 7.0 ? 20.0 * g : 0.0) + noise(random);
  });
  Signal clipped = truth;
  std::ranges::for_each(clipped.value, [](double& value) { value = std::min(value, 156.9); });
  const Heard whole = fly_log(log_of(truth), question());
  const Heard bounded = fly_log(log_of(clipped), question());
  EXPECT_FALSE(whole.is_lower_bound);
  EXPECT_TRUE(bounded.is_lower_bound);
  ASSERT_EQ(bounded.clipped.size(), 1U);
  EXPECT_TRUE(says(bounded, "axial", {"156.9", "16"}));
  EXPECT_TRUE(says(bounded, "lower bounds") && says(bounded, "apogee comes"));
  EXPECT_NEAR(whole.fastest.value, 38.0 * g, 2.0);
  EXPECT_NEAR(bounded.fastest.value, 30.0 * g, 2.0);
  ASSERT_TRUE(whole.apogee_s && bounded.apogee_s);
  EXPECT_NEAR(*whole.apogee_s - *bounded.apogee_s, 8.0, 0.5);
  EXPECT_NE(text_of(bounded).find("are lower bounds"), std::string::npos);
  EXPECT_EQ(text_of(whole).find("are lower bounds"), std::string::npos);

  ImuLog two = log_of(clipped);
  two.second_axial = truth;
  const Heard helped = fly_log(std::move(two), question());
  EXPECT_FALSE(helped.is_lower_bound) << "the other accelerometer measures";
  EXPECT_NEAR(helped.fastest.value, whole.fastest.value, 1.0);
  EXPECT_FALSE(says(helped, "lower bounds"));
}

// From 1 g at 5.0 s to the end of the range, 6 g, at 5.2 s: the plan's 2.5 g are passed at 5.06 s, and the hold is 0.1
// s.
TEST(FlyLog, OfASlowLogThatSaturatesIsNotDetectedBeforeTheLineHasPassedTheThreshold) {
  std::mt19937 random{test::seed()};
  std::normal_distribution<double> noise{0.0, 0.05};
  const Heard heard =
      fly_log(log_of(signal(20.0, 0.2,
                            [&](double t) {
                              return t < 5.1 ? g + (t > 4.9 ? 0.0 : noise(random)) : t < 9.1 ? 6.0 * g : noise(random);
                            }),
                     0.2),
              question());
  ASSERT_EQ(heard.clipped.size(), 1U);
  EXPECT_GE(heard.detected_s.value(), 5.16);
  EXPECT_LE(heard.detected_s.value(), 5.20);
}

TEST(FlyLog, OfTwoAccelerometersThatDisagreeIsMissedByAPlanThatAsksForTwo) {
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  log.second_axial = signal(20.0, 0.01, [](double) { return g; });
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_EQ(finding(heard), Finding::missed);
  EXPECT_EQ(heard.detected_s, std::nullopt);
}

TEST(FlyLog, ComparesWithTheLogsOwnHeight) {
  ImuLog log = log_of(signal(20.0, 0.01, constant_push));
  log.height = signal(20.0, 0.05, [](double t) {
    const double coast = std::max(t - 7.0, 0.0);
    const double push = std::clamp(t - 5.0, 0.0, 2.0);
    return 250.0 + 2.0 * g * push * push + 8.0 * g * coast - 0.5 * g * coast * coast;
  });
  const Heard heard = fly_log(std::move(log), question());
  EXPECT_NEAR(*heard.log_height.apogee_s, 15.0, 0.06);
  EXPECT_NEAR(heard.log_height.apogee_m, 40.0 * g, 0.5);
  EXPECT_NEAR(heard.apogee_m, heard.log_height.apogee_m, 2.0);
  const json::Value data = data_of(heard);
  EXPECT_EQ(data["log"], "made.csv");
  EXPECT_NEAR(data["detected_since_lift_off_s"].number(), 0.1, 0.05);
  EXPECT_NEAR(data["log_itself"]["apogee_s"].number(), 15.0, 0.06);
}

TEST(FlyLog, IsRefusedWithAPlanOfTheTunnel) {
  Question tunnel = question();
  tunnel.plan.run.start = core::Start::tunnel;
  test::expect_refused(text::ErrorKind::bad_configuration, {"the plan default begins on command"},
                       [&] { (void)fly_log(log_of(signal(1.0, 0.01, constant_push)), tunnel); });
}

}  // namespace
}  // namespace fantail::listen
