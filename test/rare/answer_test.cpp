// SPDX-License-Identifier: MIT
#include "rare/study.hpp"
#include "test.hpp"

namespace fantail::rare {
namespace {

Study of(const Estimate& estimate) {
  return {.scenario = "a rocket",
          .options = {.campaign = {.scenario = "a_rocket"}, .question = {.outcome = "held"}},
          .estimate = estimate};
}

Estimate one_in_a_million() {
  return {
      .end = End::found,
      .probability = 1e-6,
      .coefficient_of_variation = 0.2,
      .low = 7e-7,
      .high = 1.5e-6,
      .levels = {{.samples = 3000, .threshold = 0.2, .share = 0.1}, {.samples = 3000, .threshold = 0.0, .share = 0.1}},
      .plain_margins = std::vector<double>(3000, 1.0),
      .points = 18'000};
}

TEST(RareAnswer, HasTheProbabilityItsIntervalAndWhatTheSearchCannotSeeInItsSentence) {
  Study study = of(one_in_a_million());
  study.modes = {{.criterion = "rest_error",
                  .share = 0.9,
                  .quantities = {{.name = "servo.lag_s", .mean_sigmas = 3.2, .deviation_sigmas = 0.3},
                                 {.name = "imu.rate_bias_deg_s", .mean_sigmas = 0.1, .deviation_sigmas = 2.4},
                                 {.name = "body.mass_kg", .mean_sigmas = 0.1, .deviation_sigmas = 1.0}}}};
  const result::Verdict verdict = answer(study).verdict;
  EXPECT_EQ(verdict.heading, "1 in 1 000 000");
  EXPECT_EQ(verdict.answer, result::Answer::none);
  const auto says = [&](const char* words) { return verdict.sentence.find(words) != std::string::npos; };
  EXPECT_TRUE(says("probability 1e-06, 95 % interval 7e-07 to 1.5e-06")) << verdict.sentence;
  EXPECT_TRUE(says("none of 3000 plain flights did, so they can be as frequent as 1 in 1 000")) << verdict.sentence;
  EXPECT_TRUE(says("rest error above its limit, 90 % (servo: lag +3.2, imu: rate bias 2.4 either way)"))
      << verdict.sentence;
}

// What nobody could have seen does not make a yes.
TEST(RareAnswer, IsAYesOnlyWhereFailuresWithoutAFigureAreAsRareToo) {
  Study study = of(one_in_a_million());
  study.options.at_most = 0.002;
  EXPECT_EQ(answer(study).verdict.answer, result::Answer::yes);
  study.events = 3;
  EXPECT_EQ(answer(study).verdict.answer, result::Answer::undecided) << "0.1 %, up to 0.26 %";
  study.events = 30;
  EXPECT_EQ(answer(study).verdict.answer, result::Answer::no);
  study.events = 0;
  study.options.at_most = 1e-5;
  EXPECT_EQ(answer(study).verdict.answer, result::Answer::undecided);
  const std::string sentence = answer(study).verdict.sentence;
  EXPECT_NE(sentence.find("Not decided: the interval meets it, but flights that fail without a figure are only "
                          "known to be rarer than 1 in 1 000. With --flights 3"),
            std::string::npos)
      << sentence;
  study.options.at_most = 1e-7;
  EXPECT_EQ(answer(study).verdict.answer, result::Answer::no);
  study.options.at_most = 1e-6;
  EXPECT_EQ(answer(study).verdict.answer, result::Answer::undecided) << "the interval is on both sides";
}

TEST(RareAnswer, SaysWhereTheSearchEndedWhenItFoundNoProbability) {
  Study study = of({.end = End::never_fails,
                    .probability = 1e-12,
                    .plain_margins = std::vector<double>(3000, 1.0),
                    .points = 30'000});
  study.led_to = "Mach number";
  study.options.at_most = 0.01;
  EXPECT_EQ(answer(study).verdict.heading, "No failure found");
  // The levels went where they went: what bounds failures of any kind are the plain flights.
  const std::string sentence = answer(study).verdict.sentence;
  EXPECT_NE(sentence.find("The first 3000 were drawn plainly, and none of them failed without one"), std::string::npos)
      << sentence;
  EXPECT_NE(sentence.find("rarer than 1 in 1 000 (95 %)"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("towards the limit of Mach number"), std::string::npos) << sentence;
  EXPECT_EQ(sentence.find("1 000 000"), std::string::npos) << sentence;
  EXPECT_EQ(answer(study).verdict.answer, result::Answer::yes);
  study.options.at_most = 1e-4;
  EXPECT_EQ(answer(study).verdict.answer, result::Answer::undecided);
  study.estimate = {.end = End::always_fails, .probability = 1.0, .points = 100};
  EXPECT_EQ(answer(study).verdict.heading, "Every flight fails");
  EXPECT_EQ(answer(study).verdict.answer, result::Answer::no);
  study.estimate = {.end = End::does_not_advance, .probability = 0.1, .stuck_at = 0.25, .points = 100};
  EXPECT_EQ(answer(study).verdict.heading, "Not found");
  EXPECT_NE(answer(study).verdict.sentence.find("have the same margin, 0.25"), std::string::npos);
}

}  // namespace
}  // namespace fantail::rare
