// SPDX-License-Identifier: MIT
#include "predict/decision.hpp"

#include "figures.hpp"
#include "input/scenario_file.hpp"
#include "predict/advice.hpp"
#include "predict/sentences.hpp"
#include "test.hpp"

namespace fantail::predict {
namespace {

using text::radians;
/// 200 runs that leave nothing to be desired.
Prediction good() {
  Prediction p;
  p.reach.angle_rad = radians(9.0);
  p.flown = input::load_scenario("tasha3_launch2", {});
  p.runs.resize(200, {.airframe = {.damping_m2 = 19.4, .torque_m = 9.6},
                      .authority_margin_rad = radians(4.9),
                      .outcome = report::Outcome::held});
  p.authority = share(200, 200);
  p.held = share(200, 200);
  p.offset_size_rad = {.mean = radians(4.1), .p5 = radians(3.0), .p50 = radians(4.1), .p95 = radians(5.2)};
  p.worst_speed = MarginsAtSpeed{.speed_m_s = 81.6, .phase_margin_rad = {.p5 = radians(45.4), .p50 = radians(57.0)}};
  p.speeds_m_s = {20.0, 81.6};
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
      "Go: the fin offset of about 4.1 degrees is within the 9 degree canard limit in all runs. Roll is held in all "
      "runs, within 10 degrees of where this law settles (at most 20 degrees from its command). This leaves "
      "out the first second of control and of each step. 95 % of the runs have a phase margin of 45 degrees or more at "
      "every speed.");
  for (const Criterion& c : d.criteria) {
    EXPECT_EQ(c.judgement, Judgement::met) << c.key;
  }
}

TEST(Decision, ThatTooFewRunsAreTheOnlyReasonOfBeginsWithThem) {
  Prediction p = good();
  p.runs.resize(20);
  p.authority = p.held = share(20, 20);
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_TRUE(d.text.starts_with("No go: 20 runs are too few to be sure of 95 %. Fly more with --runs. The fin offset"))
      << d.text;
  EXPECT_TRUE(criterion(d, "held").clause.starts_with(
      "20 runs are too few to be sure of 90 %. Fly more with --runs. Roll is held"))
      << d.text;
}

// "Held" alone misleads who does not know that the law settles off its reference.
TEST(Decision, SaysWhatHeldMeansAndHowFarFromTheReferenceThatIs) {
  Prediction p = good();
  p.settle_off_rad = Quantiles{.p50 = radians(13.0)};
  EXPECT_EQ(figures(criterion(decide(p, {}), "held").clause), (Numbers{"10", "13.0", "20"}));
  p.flown.plan.offset.rejection = core::OffsetRejection::integral;
  EXPECT_EQ(figures(criterion(decide(p, {}), "held").clause), Numbers{"10"});
}

// A run may end control early and be not held for it, or for another reason: it counts all the same.
TEST(Decision, CountsEveryRunInWhichControlEndedEarly) {
  Prediction p = good();
  p.held = share(197, 200);
  for (std::size_t i = 0; i < 3; ++i) {
    p.runs[i].outcome = i == 0 ? report::Outcome::cut_short : report::Outcome::not_held;
    p.runs[i].ended_early = true;
    p.runs[i].verdict = "Control ended at 9.50 s, 0.78 s before apogee: the rocket tilted too far.";
  }
  const Decision d = decide(p, {});
  EXPECT_EQ(figures(criterion(d, "held").clause), (Numbers{"98", "10", "20", "3", "200", "0", "9.50", "0.78"}));
  EXPECT_EQ(criterion(d, "held").judgement, Judgement::met);
}

TEST(Decision, NamesRunsWhoseAscentFailsAndNotThatThisEndsControl) {
  const std::string turned_over = "The rocket turned over";
  Prediction p = good();
  p.held = share(120, 200);
  for (std::size_t i = 0; i < 80; ++i) {
    p.runs[i].outcome = report::Outcome::ascent_failed;
    p.runs[i].ended_early = true;
    p.runs[i].verdict = turned_over + ": from 1.74 s on its nose pointed below the horizon.";
  }
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(figures(d.text), (Numbers{"60", "80", "200", "0", "1.74"}));
  EXPECT_NE(d.text.find("run 0: " + turned_over), std::string::npos) << d.text;
}

TEST(Decision, IsNoGoWhenTheOffsetIsLargerThanTheLimit) {
  Prediction p = good();
  p.reach.angle_rad = radians(6.0);
  p.authority = share(4, 200);
  p.offset_size_rad.p50 = radians(7.14);
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(d.text,
            "No go: the fin offset of about 7.1 degrees is larger than the 6 degree canard limit in 98 % of the runs.");
  EXPECT_EQ(criterion(d, "authority").judgement, Judgement::not_met);
  EXPECT_EQ(criterion(d, "held").judgement, Judgement::met);
}

TEST(Decision, AnOffsetAtTheLimitIsNotCalledLarger) {
  Prediction p = good();
  p.authority = share(0, 200);
  p.offset_size_rad.p50 = radians(9.0);
  const std::string larger = decide(p, {}).text;
  p.runs[5].authority_margin_rad = -1e-8;
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(figures(d.text), (Numbers{"9.0", "9"}));
  EXPECT_NE(d.text, larger);
}

TEST(Decision, IsNoGoWhenTheLoopIsTooNearToSwinging) {
  Prediction p = good();
  p.worst_speed->phase_margin_rad.p5 = radians(22.6);  // the median is 57
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(figures(d.text), (Numbers{"82", "5", "23", "30"}));
  EXPECT_EQ(criterion(d, "phase_margin").judgement, Judgement::not_met);
  EXPECT_TRUE(decide(p, {.phase_margin_rad = radians(20.0)}).go);
}

TEST(Decision, IsNoGoWhenRollIsNotHeldAndSaysHowFastItSpins) {
  Prediction p = good();
  p.held = share(100, 200);
  p.spin_rate_rad_s = Quantiles{.p50 = radians(128.7)};
  const Decision d = decide(p, {});
  EXPECT_EQ(criterion(d, "held").judgement, Judgement::not_met);
  EXPECT_EQ(figures(d.text), (Numbers{"50", "129"}));
}

/// Under control from 0.6 to 9.8 s after lift-off.
Prediction on_a_leaning_guide(double tilt_deg) {
  Prediction p = good();
  p.flown.guide.tilt_rad = radians(tilt_deg);
  p.runs[7].reference_rad.resize(30);
  p.runs[7].reference_rad.resize(491, 0.0);
  p.runs[7].reference_rad.resize(520);
  return p;
}

// 8.0 s: a point mass, integrated apart from Fantail.
TEST(Decision, IsNoGoWhenTheTiltLimitWouldEndControlEarlyWhichTheStraightLineDoesNotShow) {
  const Decision d = decide(on_a_leaning_guide(15.0), {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(figures(d.text), (Numbers{"15", "60", "8.0"}));
  EXPECT_EQ(criterion(d, "tilt_limit").judgement, Judgement::not_met);
  EXPECT_NEAR(std::stod(figures(criterion(d, "tilt_limit").found).at(0)), 8.0, 0.05);
}

TEST(Decision, AdvisesATiltWithWhichTheTiltLimitIsNotPassedEarly) {
  const Prediction p = on_a_leaning_guide(15.0);
  const Decision d = decide(p, {});
  ASSERT_EQ(d.advice.size(), 1U);
  const double advised_deg = std::stod(figures(d.advice[0]).at(0));
  EXPECT_TRUE(decide(on_a_leaning_guide(advised_deg), {}).go);
  EXPECT_FALSE(decide(on_a_leaning_guide(advised_deg + 0.5), {}).go);
}

TEST(Decision, AGuideThatHardlyLeansIsNoCriterion) {
  EXPECT_EQ(decide(on_a_leaning_guide(2.9), {}).criteria.size(), 3U);
}

void end_with(Prediction& p, std::size_t from, std::size_t to, report::Outcome outcome, const std::string& verdict) {
  for (std::size_t i = from; i < to; ++i) {
    p.runs[i].outcome = outcome;
    p.runs[i].verdict = verdict;
  }
}

// It used to be "Go": 150 of the 150 that could be judged.
TEST(Decision, WhatCannotBeJudgedCountsAgainstALaunch) {
  Prediction p = good();
  end_with(p, 150, 200, report::Outcome::not_judged,
           "Roll not judged: control lasted only 0.63 s; canards at their limit 0.0 % of control time.");
  p.held = share(150, 200);
  p.not_judged = 50;
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(figures(d.text), (Numbers{"75", "50", "200", "150", "0.63"}));
  EXPECT_EQ(figures(criterion(d, "held").found), (Numbers{"75", "68", "81", "50", "200"}));
}

TEST(Decision, ALaunchThatCannotBeJudgedAtAllIsNoGoAndSaysWhy) {
  Prediction p = good();
  const std::string why = "the reference was never constant";
  end_with(p, 0, 200, report::Outcome::not_judged, "Roll not judged: " + why + ".");
  p.held = share(0, 200);
  p.not_judged = 200;
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(figures(d.text), Numbers{"0"});
  EXPECT_NE(d.text.find("run 0: " + why), std::string::npos) << d.text;
}

TEST(Decision, ARocketThatNeverComesUnderControlIsNoGoAndTheCauseIsSaidOnce) {
  Prediction p = good();
  end_with(p, 0, 200, report::Outcome::no_control, "No control: no launch was detected. Canard 1 dead from 2.00 s.");
  p.held = share(0, 200);
  p.without_control = 200;
  p.worst_speed.reset();
  p.speeds_m_s.clear();
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(figures(d.text), Numbers{"0"});
  EXPECT_NE(d.text.find("run 0: no launch was detected"), std::string::npos) << d.text;
  EXPECT_EQ(decide(p, {.held_share = 0.0}).text, d.text);
}

TEST(Decision, SaysWhatTheFirstRunThatIsNotHeldCameTo) {
  Prediction p = good();
  end_with(p, 7, 50, report::Outcome::not_held,
           "Roll not held: up to 28.2 deg from where this law settles; canards at their limit 29.0 % of control time.");
  end_with(p, 50, 60, report::Outcome::oscillates, "The canards oscillate at 13 Hz between -1.3 and 8.3 deg. Roll.");
  p.held = share(147, 200);
  EXPECT_EQ(figures(decide(p, {}).text), (Numbers{"74", "7", "28.2", "10", "200", "50", "13", "-1.3", "8.3"}));
}

TEST(Decision, NumbersAreNotRoundedToWhatIsAskedFor) {
  Prediction p = good();
  p.reach.angle_rad = radians(6.0);
  p.authority = share(90, 200);
  p.offset_size_rad.p50 = radians(6.03);
  EXPECT_EQ(figures(criterion(decide(p, {}), "authority").clause), (Numbers{"6.03", "6", "55"}));
  p = good();
  p.worst_speed->phase_margin_rad.p5 = radians(29.96);
  EXPECT_EQ(figures(decide(p, {}).text), (Numbers{"82", "5", "29.9", "30"}));
  p.held = share(189, 200);  // the low end is 90.42 %
  EXPECT_EQ(figures(criterion(decide(p, {.held_share = 0.905}), "held").found), (Numbers{"94", "90", "97"}));
  EXPECT_EQ(figures(criterion(decide(p, {.held_share = 0.905}), "held").required), Numbers{"90.5"});
}

/// The longest sentence, in words; what stands in brackets counts too.
std::size_t most_words(std::string_view text) {
  std::size_t most = 0;
  std::size_t words = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool word_ends = text[i] != ' ' && (i + 1 == text.size() || text[i + 1] == ' ');
    words += word_ends ? 1 : 0;
    most = std::max(most, words);
    words = word_ends && text[i] == '.' ? 0 : words;
  }
  return most;
}

TEST(Decision, SpeaksInShortSentences) {
  Prediction p = good();
  p.resonance = RollResonance{.near = 30, .past = 10, .with_canards = 196, .runs = 200};
  p.settle_off_rad = Quantiles{.p50 = radians(13.0)};
  Prediction lost = on_a_leaning_guide(15.0);
  lost.reach.angle_rad = radians(6.0);
  lost.authority = share(1, 200);
  lost.held = share(0, 200);
  lost.spin_rate_rad_s = Quantiles{.p50 = radians(141.0)};
  lost.worst_speed->phase_margin_rad.p5 = radians(16.2);
  lost.runs[158].outcome = report::Outcome::not_judged;
  lost.runs[158].verdict = "Roll not judged: the reference was never constant for long enough.";
  for (const Decision& d : {decide(p, {}), decide(lost, {})}) {
    EXPECT_LE(most_words(d.text), 28U) << d.text;
    EXPECT_EQ(d.text.find(';'), std::string::npos) << d.text;
  }
}

TEST(Decision, NamesWhatTheScenarioSpreadsAndAPredictionDoesNotDraw) {
  Prediction p = good();
  const std::string without = decide(p, {}).text;
  p.request.not_drawn = {"wind.speed_m_s"};
  const Decision one = decide(p, {});
  EXPECT_TRUE(one.go);
  EXPECT_NE(one.text.find("wind.speed_m_s"), std::string::npos) << one.text;
  EXPECT_NE(one.text.find("fantail campaign"), std::string::npos) << one.text;
  p.request.not_drawn = {"a.one", "a.two", "a.three", "a.four", "a.five"};
  EXPECT_EQ(figures(decide(p, {}).text).back(), "2") << "three are named, and two more";
  EXPECT_EQ(without.find("fantail campaign"), std::string::npos);
}

TEST(Decision, GainsThatHoldNothingAreNoGo) {
  Prediction p = good();
  p.worst_speed.reset();
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(criterion(d, "phase_margin").judgement, Judgement::not_met);
  EXPECT_NE(d.text.find("gains"), std::string::npos) << d.text;
}

}  // namespace
}  // namespace fantail::predict
