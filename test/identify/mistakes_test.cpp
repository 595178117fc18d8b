// SPDX-License-Identifier: MIT
// Mistakes that people make with a log, planted one at a time: each has to be named.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "figures.hpp"
#include "identify/doubts.hpp"
#include "identify/identification.hpp"
#include "identify/model/planted.hpp"
#include "identify/planted_log.hpp"
#include "identify/result/words.hpp"
#include "identify/study.hpp"
#include "logs/refused.hpp"
#include "seed.hpp"

namespace fantail::identify {
namespace {

using namespace model;
using namespace result;

Question asked() {
  Question question = planted_question("0");
  question.options.with_error_map = false;
  return question;
}

logs::RollLog noisy_log(const Planting& planting, const Noise& noise, std::uint64_t seed) {
  Record record = planted_record(planting);
  add_noise(record, noise, seed);
  logs::RollLog log = planted_log(planting);
  log.roll_angle_rad = record.roll_angle_rad;
  log.roll_rate_rad_s = record.roll_rate_rad_s;
  return log;
}

bool holds(const std::string& text, const std::string& word) { return text.find(word) != std::string::npos; }

bool knows_both(const Uncertainty& known) { return known.alpha_identifiable && known.beta_identifiable; }

/// What is said of a lag of the canard column, with "--nodes" where these explain it, too; empty: nothing.
std::string doubt_of_lag(const WindowFindings& window) {
  for (const std::string& remark : remarks(window, window.results[0])) {
    if (holds(remark, "canard") && holds(remark, "--fit-lag")) {
      return remark;
    }
  }
  return {};
}

std::string said(const WindowFindings& window) {
  std::string all = window.results[0].uncertainty->verdict;
  for (const std::string& remark : remarks(window, window.results[0])) {
    all += "\n" + remark;
  }
  return all;
}

void scale_canards(logs::RollLog& log, double factor) {
  for (double& angle : log.canard_rad) {
    angle *= factor;
  }
}

TEST(Mistakes, ACanardColumnOfTheWrongSignIsNamed) {
  logs::RollLog log = noisy_log({}, {}, 3);
  scale_canards(log, -1.0);
  const WindowFindings found = study(log, asked()).windows[0];
  EXPECT_NEAR(found.results[0].model.beta_m, -9.0, 0.3);
  EXPECT_TRUE(holds(said(found), "opposite sign") && !holds(said(found), "excitation")) << said(found);
}

TEST(Mistakes, ACanardColumnInRadiansIsNamed) {
  logs::RollLog log = noisy_log({}, {}, 3);
  scale_canards(log, radians_per_degree);
  const WindowFindings found = study(log, asked()).windows[0];
  EXPECT_NEAR(found.results[0].model.beta_m, 9.0 / radians_per_degree, 20.0);
  EXPECT_NE(said(found).find("radians"), std::string::npos) << said(found);
}

TEST(Mistakes, ACanardColumnInDegreesThatIsReadAsRadiansIsNamed) {
  logs::RollLog log = noisy_log({}, {}, 3);
  scale_canards(log, 1.0 / radians_per_degree);
  const std::string text = said(study(log, asked()).windows[0]);
  EXPECT_NE(text.find("degrees"), std::string::npos) << text;
}

// With a measured start the error of the first sample is in all of them.
TEST(Mistakes, NothingIsNamedInAGoodLog) {
  Question question = asked();
  question.options.start = Start::fitted;
  const WindowFindings found = study(noisy_log({}, {}, 3), question).windows[0];
  EXPECT_TRUE(knows_both(*found.results[0].uncertainty));
  EXPECT_EQ(remarks(found, found.results[0]), std::vector<std::string>{});
}

// "identifiable" beside few effective samples is no contradiction, and says why.
TEST(Mistakes, WhatLooksLikeAContradictionBesideTheVerdictIsExplained) {
  const WindowFindings found = study(noisy_log({}, {}, 3), asked()).windows[0];
  EXPECT_TRUE(knows_both(*found.results[0].uncertainty) && holds(said(found), "effective samples"));
}

// In either loop, whatever else is right; in the closed one, with the canards, as a doubt about the numbers.
TEST(Mistakes, AResidualThatIsCorrelatedBeyondChanceIsSaidBesideTheVerdict) {
  Record record = planted_record({});
  add_noise(record, {}, 3);
  Identification found =
      identify(record, tasha, {.nodes = NodeTimes{0.0}, .start = Start::fitted, .with_error_map = false});
  const auto says = [&](Loop loop, const ResidualTests& tests) {
    found.loop = loop;
    found.residual_tests = tests;
    const std::vector<std::string> all = doubts(record, tasha, Start::fitted, found);
    return all.empty() ? "" : all.back();
  };
  const ResidualTests beyond{
      .own_correlation = 0.38, .canard_correlation = -0.41, .chance = 0.12, .canard_chance = 0.17};
  for (const Loop loop : {Loop::open, Loop::closed}) {
    const std::string text = says(loop, beyond);
    EXPECT_TRUE(tells(text, {"0.38", "0.12", "-0.41", "0.17"})) << text;
    EXPECT_EQ(holds(text, "servos"), loop == Loop::closed) << text;
    EXPECT_EQ(says(loop, {.own_correlation = 0.1, .canard_correlation = -0.1, .chance = 0.12, .canard_chance = 0.17}),
              "");
  }
}

TEST(Mistakes, ALagBeyondThatWhichIsFittedIsNamedWithItsOption) {
  logs::RollLog log = noisy_log({.sample_hz = 500.0}, {.angle_deg = 0.3, .rate_deg_s = 0.3}, 8);
  delay_canards(log, 40);
  const std::string text = said(study(log, asked()).windows[0]);
  EXPECT_TRUE(tells(text, {"80"}) && holds(text, "late") && holds(text, "--fit-lag")) << text;
  EXPECT_TRUE(holds(text, "use --lag 0.08")) << text;
}

TEST(Mistakes, WithOtherCanardsThanThoseThatFlewNoLagIsNamed) {
  for (const double hz : {0.6, 1.7, 2.9}) {
    logs::RollLog log = noisy_log({.sample_hz = 500.0}, {.angle_deg = 0.3, .rate_deg_s = 1.0}, 9);
    for (std::size_t i = 0; i < log.time_s.size(); ++i) {
      log.canard_rad[i] += radians_per_degree * 4.0 * std::sin(6.283 * hz * log.time_s[i]);
    }
    const std::string text = said(study(log, asked()).windows[0]);
    EXPECT_FALSE(holds(text, "use --lag")) << hz << text;
  }
}

TEST(Mistakes, AnotherFitThatPrintsTheSameNumbersIsNoDoubt) {
  const Planting planting{.node_time_s = {0.0, 2.0, 4.0}, .node_deg = {-5.0, -5.002, -5.0}, .sample_hz = 500.0};
  const std::string text =
      said(study(noisy_log(planting, {.angle_deg = 1e-4, .rate_deg_s = 1e-3}, 4), asked()).windows[0]);
  EXPECT_EQ(text.find("With more nodes"), std::string::npos) << text;
}

TEST(Mistakes, ARollThatNeverMovesIsRefused) {
  logs::RollLog log = planted_log({});
  log.roll_angle_rad.assign(log.time_s.size(), 0.0);
  log.roll_rate_rad_s.assign(log.time_s.size(), 0.0);
  test::expect_refused(text::ErrorKind::bad_data, {"roll angle and roll rate are constant in all samples"},
                       [&] { (void)study(log, asked()); });
}

TEST(Mistakes, ALagOfTwentyMillisecondsIsNamedUnderANoisyGyro) {
  const std::uint64_t first_seed = test::seed(500);
  constexpr int records = 20;
  int named = 0;
  int surely = 0;
  for (int i = 0; i < records; ++i) {
    logs::RollLog log = noisy_log({.sample_hz = 500.0}, {.angle_deg = 0.3, .rate_deg_s = 3.0},
                                  first_seed + static_cast<std::uint64_t>(i));
    delay_canards(log, 10);
    const std::string doubt = doubt_of_lag(study(log, asked()).windows[0]);
    named += doubt.empty() ? 0 : 1;
    surely += doubt.empty() || holds(doubt, "--nodes") ? 0 : 1;
  }
  RecordProperty("named", named);
  RecordProperty("surely", surely);
  EXPECT_GE(named, 14);   // 113 of 120 are, over six seeds
  EXPECT_GE(surely, 10);  // 105 of 120
}

TEST(Mistakes, ALagIsNotNamedWhereThereIsNone) {
  const std::uint64_t first_seed = test::seed(700);
  constexpr int records = 20;
  int named = 0;
  for (int i = 0; i < records; ++i) {
    const logs::RollLog log = noisy_log({.sample_hz = 500.0}, {.angle_deg = 0.3, .rate_deg_s = 3.0},
                                        first_seed + static_cast<std::uint64_t>(i));
    named += doubt_of_lag(study(log, asked()).windows[0]).empty() ? 0 : 1;
  }
  RecordProperty("named", named);
  EXPECT_LE(named, 2);  // one of a hundred is expected
}

// The node in the middle of each interval is missing; there is no lag.
TEST(Mistakes, ALagThatMoreNodesTakeAwayIsOneOfTwoCauses) {
  const Planting curved{
      .node_time_s = {0.0, 1.0, 2.0, 3.0, 4.0}, .node_deg = {-5.0, -4.8, -5.0, -5.2, -5.0}, .sample_hz = 500.0};
  Question question = asked();
  question.options.start = Start::fitted;
  question.nodes = "even:2";
  const WindowFindings found = study(noisy_log(curved, {.angle_deg = 0.02, .rate_deg_s = 0.1}, 3), question).windows[0];
  const std::string doubt = doubt_of_lag(found);
  EXPECT_TRUE(doubt.empty() || holds(doubt, "--nodes")) << said(found);
  EXPECT_TRUE(tells(said(found), {"5", "3"})) << said(found);
}

// Where alpha and beta grow with 1 / sqrt(1 - M2), the air is as much denser than the log says.
TEST(Mistakes, ALagThatTheMachNumberTakesAwayIsOneOfTwoCauses) {
  logs::RollLog log = noisy_log({.seconds = 8.0, .sample_hz = 500.0, .speed_begin_m_s = 160.0, .speed_end_m_s = 40.0},
                                {.angle_deg = 0.02, .rate_deg_s = 0.1}, 3);
  for (const double speed_m_s : log.speed_m_s) {
    const double density_kg_m3 = 1.2 * std::sqrt(1.0 - std::pow(speed_m_s / 340.0, 2));
    log.height_m.push_back(-8500.0 * std::log(density_kg_m3 / 1.225));
  }
  Question question = asked();
  question.options.start = Start::fitted;
  question.record.density_kg_m3.reset();
  const WindowFindings found = study(log, question).windows[0];
  const std::string doubt = doubt_of_lag(found);
  EXPECT_TRUE(doubt.empty() || holds(doubt, "--nodes")) << said(found);
}

// The angle alone is fitted well, and the rate is 57 times as slow.
TEST(Mistakes, WhatTheRollRateContradictsIsNotCalledIdentifiable) {
  logs::RollLog log = noisy_log({.seconds = 10.0, .start_rate_deg_s = 0.0}, {}, 3);
  for (double& rate : log.roll_rate_rad_s) {
    rate *= radians_per_degree;
  }
  Question question = asked();
  question.options.start = Start::fitted;
  const WindowFindings found = study(log, question).windows[0];
  const std::string text = said(found);
  EXPECT_FALSE(found.results[0].uncertainty->alpha_identifiable || found.results[0].uncertainty->beta_identifiable);
  EXPECT_TRUE(holds(found.results[0].uncertainty->verdict, "roll rate")) << text;
  EXPECT_FALSE(holds(text, "are identifiable") || holds(text, "effective samples")) << text;
}

TEST(Mistakes, AFewSamplesThatCarryTheCostAreNamed) {
  logs::RollLog log = noisy_log({}, {.angle_deg = 0.1}, 3);
  log.roll_angle_rad[200] += 20.0 * radians_per_degree;
  log.roll_angle_rad[300] += 20.0 * radians_per_degree;
  const std::string text = said(study(log, asked()).windows[0]);
  EXPECT_TRUE(tells(text, {"5", "401"})) << text;
}

TEST(Mistakes, HubersLossIsRecommendedForOutliersWithWhatItGives) {
  logs::RollLog log = noisy_log({}, {.angle_deg = 0.1}, 3);
  log.roll_angle_rad[200] += 20.0 * radians_per_degree;
  log.roll_angle_rad[300] += 20.0 * radians_per_degree;
  Question question = asked();
  const std::string advice = said(study(log, question).windows[0]);
  question.options.loss = Loss::huber;
  question.options.start = Start::fitted;
  const WindowFindings followed = study(log, question).windows[0];
  const Identification& robust = followed.results[0];
  EXPECT_NE(advice.find("--loss huber"), std::string::npos) << advice;
  EXPECT_TRUE(holds(advice, "alpha " + with_deviation(robust, 0))) << advice;
  EXPECT_EQ(said(followed).find("outliers"), std::string::npos) << said(followed);
  EXPECT_TRUE(holds(said(followed), "Huber")) << said(followed);
}

TEST(Mistakes, MissingNodesAreNamed) {
  const Planting curved{.node_time_s = {0.0, 2.0, 4.0}, .node_deg = {-4.0, -6.0, -4.5}};
  const std::string text = said(study(noisy_log(curved, {.angle_deg = 0.1}, 3), asked()).windows[0]);
  EXPECT_NE(text.find("ore nodes"), std::string::npos) << text;
}

// A small motion that is seen clearly is excitation enough; a large one under much noise is not.
TEST(Mistakes, ExcitationIsJudgedByWhatItTells) {
  const logs::RollLog small = noisy_log({.canard_amplitude_deg = 0.2}, {.angle_deg = 0.001, .rate_deg_s = 0.01}, 3);
  EXPECT_TRUE(knows_both(*study(small, asked()).windows[0].results[0].uncertainty));
  const logs::RollLog lost = noisy_log({.canard_amplitude_deg = 0.2, .start_rate_deg_s = -90.0}, {.angle_deg = 3.0}, 4);
  const Uncertainty unknown = *study(lost, asked()).windows[0].results[0].uncertainty;
  EXPECT_TRUE(!knows_both(unknown) && holds(unknown.verdict, "too little excitation")) << unknown.verdict;
}

// alpha and beta are inversely proportional to the reference area, and so are the ranges of the search.
TEST(Mistakes, ALargerReferenceAreaChangesNumbersButNotTheFit) {
  constexpr double times = 1e4;
  const logs::RollLog log = noisy_log({}, {.angle_deg = 0.1}, 3);
  Question question = asked();
  const Identification small = study(log, question).windows[0].results[0];
  question.airframe.reference_area_m2 *= times;
  const Identification large = study(log, question).windows[0].results[0];
  EXPECT_NEAR(large.model.alpha_m2 * times, small.model.alpha_m2, 1e-3);
  ASSERT_TRUE(large.uncertainty->alpha_profile_m2.low && large.uncertainty->alpha_profile_m2.high);
  EXPECT_NEAR(*large.uncertainty->alpha_profile_m2.low * times, *small.uncertainty->alpha_profile_m2.low, 1e-2);
}

}  // namespace
}  // namespace fantail::identify
