// SPDX-License-Identifier: MIT
#include "predict/decision.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "predict/sentences.hpp"

namespace fantail::predict {
namespace {

using text::radians;

/// 200 runs that leave nothing to be desired.
Prediction good() {
  Prediction p;
  p.limit_rad = radians(9.0);
  p.runs.resize(200);
  p.authority = share(200, 200);
  p.held = share(200, 200);
  p.offset_size_rad = {.mean = radians(4.1), .p5 = radians(3.0), .p50 = radians(4.1), .p95 = radians(5.2)};
  p.worst_speed = MarginsAtSpeed{.speed_m_s = 81.6, .phase_margin_rad = {.p50 = radians(45.4)}};
  return p;
}

const Criterion& criterion(const Decision& decision, std::string_view key) {
  return *std::ranges::find(decision.criteria, key, &Criterion::key);
}

TEST(Decision, IsGoWhenEveryCriterionIsMetAndSaysWithWhat) {
  const Decision d = decide(good(), {});
  EXPECT_TRUE(d.go);
  EXPECT_EQ(
      d.text,
      "Go: the fin offset of about 4.1 degrees is within the 9 degree canard limit in all runs; roll is held in all "
      "runs; the median phase margin is at least 45 degrees at every speed.");
  for (const Criterion& c : d.criteria) {
    EXPECT_EQ(c.judgement, Judgement::met) << c.key;
  }
}

TEST(Decision, IsNoGoWhenTheOffsetIsLargerThanTheLimit) {
  Prediction p = good();
  p.limit_rad = radians(6.0);
  p.authority = share(4, 200);
  p.offset_size_rad.p50 = radians(7.14);
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(d.text,
            "No go: the fin offset of about 7.1 degrees is larger than the 6 degree canard limit in 98 % of the runs.");
  EXPECT_EQ(criterion(d, "authority").judgement, Judgement::not_met);
  EXPECT_EQ(criterion(d, "held").judgement, Judgement::met);
}

TEST(Decision, IsNoGoWhenTheLoopIsTooNearToSwinging) {
  Prediction p = good();
  p.worst_speed->phase_margin_rad.p50 = radians(22.6);
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(d.text, "No go: at 82 m/s the median phase margin is 23 degrees, less than the 30 asked for.");
  EXPECT_TRUE(decide(p, {.phase_margin_rad = radians(20.0)}).go);
}

TEST(Decision, IsNoGoWhenRollIsNotHeldAndSaysHowFastItSpins) {
  Prediction p = good();
  p.held = share(100, 200);
  p.spin_rate_rad_s = Spread{.p50 = radians(128.7)};
  EXPECT_EQ(
      decide(p, {}).text,
      "No go: roll is held in only 50 % of the runs (without authority it turns at about 129 degrees a second at top "
      "speed).");
}

// 73 of 73 is the least that can promise 95 %: 73 / (73 + 1.96^2) = 0.950.
TEST(Decision, RunsThatAreTooFewToTellAreNoGo) {
  Prediction p = good();
  p.authority = share(72, 72);
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_NE(d.text.find("in all runs, but 72 runs are too few to be sure of 95 %: take more with --runs"),
            std::string::npos)
      << d.text;
  p.authority = share(73, 73);
  EXPECT_TRUE(decide(p, {}).go);
}

TEST(Decision, WhatCannotBeJudgedIsSaidAndDoesNotCount) {
  Prediction p = good();
  p.held = share(0, 0);
  p.not_judged = 200;
  const Decision d = decide(p, {});
  EXPECT_TRUE(d.go);
  EXPECT_EQ(criterion(d, "held").judgement, Judgement::not_judged);
  EXPECT_NE(d.text.find("Not judged: whether roll is held"), std::string::npos) << d.text;
}

TEST(Decision, ARocketThatNeverComesUnderControlIsNoGo) {
  Prediction p = good();
  p.held = share(0, 200);
  p.without_control = 200;
  p.worst_speed.reset();
  EXPECT_EQ(decide(p, {}).text,
            "No go: roll is held in none of the runs (control never began in 200 of 200); control never begins.");
}

TEST(Decision, GainsThatHoldNothingAreNoGo) {
  Prediction p = good();
  p.worst_speed.reset();
  EXPECT_EQ(decide(p, {}).text, "No go: the gains are too small to hold anything.");
}

TEST(Percent, DoesNotRoundToAllOrNone) {
  EXPECT_EQ(percent(0.0), "0 %");
  EXPECT_EQ(percent(0.004), "0.4 %");
  EXPECT_EQ(percent(0.5), "50 %");
  EXPECT_EQ(percent(0.996), "99.6 %");
  EXPECT_EQ(percent(1.0), "100 %");
  EXPECT_EQ(percent(0.99999), "99.9 %");
  EXPECT_EQ(percent(0.00001), "0.1 %");
}

}  // namespace
}  // namespace fantail::predict
