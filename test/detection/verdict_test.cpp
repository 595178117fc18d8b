// SPDX-License-Identifier: MIT
// What is asked of a rule, and what the report says came of it.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "detection/report.hpp"

namespace fantail::detection {
namespace {

/// As if so many events had been played.
Report of(const std::string& plan, std::vector<Kind> kinds) {
  const std::array<std::string, 1> names{plan};
  Report report{.campaign = {.rules = rules_of(names), .kinds = std::move(kinds)}, .results = {}};
  for (const Kind kind : report.campaign.kinds) {
    report.results.of_kind[index(kind)].emplace(1U);
  }
  return report;
}

Count& count_of(Report& report, Kind kind, Condition condition = Condition::well) {
  return report.results.of_kind[index(kind)]->of_rule[0][static_cast<std::size_t>(condition)];
}

bool says(const Report& report, const std::string& text) {
  const result::Document document = answer(report);
  const std::string outputs[]{result::text(document), result::html(document), result::json(document)};
  return std::ranges::all_of(outputs, [&](const std::string& all) { return all.find(text) != std::string::npos; });
}

std::string page_of(const Report& report) { return result::html(answer(report)); }
json::Value said_of(const Report& report) { return json::parse(result::json(answer(report))); }

TEST(DetectionVerdict, MissedLaunchesAreJudgedByTheBoundAndNotByWhatWasSeen) {
  Report report = of("tasha3_launch2", {Kind::launch});
  report.at_most = 0.001;
  count_of(report, Kind::launch) = {.events = 5, .detected = 5, .controlling = 5};
  EXPECT_EQ(verdict(requirements(report)), Verdict::not_met);
  EXPECT_TRUE(
      says(report, "missed 0 (at most 45.1 %) of 5 launches, and at most 0.1 % asked for; more launches may show it"));
  count_of(report, Kind::launch) = {.events = 3'000, .detected = 3'000, .controlling = 3'000};
  EXPECT_EQ(verdict(requirements(report)), Verdict::met);
  count_of(report, Kind::launch).detected = 2'996;
  EXPECT_EQ(verdict(requirements(report)), Verdict::not_met);
  EXPECT_FALSE(says(report, "more launches may show it"));
  report.at_most = 1.0;
  EXPECT_EQ(verdict(requirements(report)), Verdict::met);
}

TEST(DetectionVerdict, OfLaunchesAloneNothingIsSaidAboutFalseActuations) {
  Report report = of("tasha3_launch2", {Kind::launch});
  count_of(report, Kind::launch) = {.events = 5, .detected = 5, .controlling = 5};
  EXPECT_EQ(verdict(requirements(report)), Verdict::not_judged);
  EXPECT_TRUE(says(report, "no event that is no launch was played with both accelerometers well"));
  EXPECT_EQ(page_of(report).find("no judged plan moved a canard"), std::string::npos);
  EXPECT_EQ(said_of(report)["verdict"], "not judged");
  EXPECT_EQ(said_of(report)["answer"], "undecided");
}

TEST(DetectionVerdict, WhereNoLaunchWasControlledNothingIsSaidOfControlInsideTheGuide) {
  Report report = of("tasha3_launch2", {Kind::launch});
  count_of(report, Kind::launch) = {.events = 5, .detected = 5};
  EXPECT_NE(page_of(report).find("none was controlled"), std::string::npos);
  count_of(report, Kind::launch).controlling = 5;
  EXPECT_EQ(page_of(report).find("none was controlled"), std::string::npos);
}

TEST(DetectionVerdict, WithBothWellAFalseActuationIsAFailureAndWithOneBadAKnownLimit) {
  Report report = of("tasha3_launch2", {Kind::shaking, Kind::gust});
  count_of(report, Kind::shaking) = {.events = 100};
  count_of(report, Kind::gust) = {.events = 200};
  count_of(report, Kind::shaking, Condition::stuck) = {.events = 50, .detected = 9, .controlling = 3};
  EXPECT_EQ(verdict(requirements(report)), Verdict::met);
  EXPECT_TRUE(says(report, "false actuations 0 (at most 1 %) in 300 events with both accelerometers well"));
  EXPECT_TRUE(
      says(report, "false actuations 3 (at most 14.8 %) in 50 events with one accelerometer bad: one that stands"));
  EXPECT_NE(page_of(report).find("300 events of 2 kinds that are no launch, both accelerometers well: no judged "
                                 "plan moved a canard."),
            std::string::npos);
  count_of(report, Kind::gust).controlling = 1;
  EXPECT_EQ(verdict(requirements(report)), Verdict::not_met);
  EXPECT_EQ(failures(report).size(), 1U);
  report.false_at_most = 0.01;
  EXPECT_EQ(verdict(requirements(report)), Verdict::not_met) << "1 of 300 may be 1.6 %";
  report.false_at_most = 0.02;
  EXPECT_EQ(verdict(requirements(report)), Verdict::met);
}

TEST(DetectionVerdict, ARecoveryWithOneBadIsNotExplainedByAShake) {
  Report report = of("tasha3_launch2", {Kind::shaking, Kind::missed_flight});
  count_of(report, Kind::shaking) = {.events = 100};
  count_of(report, Kind::shaking, Condition::stuck) = {.events = 40};
  count_of(report, Kind::missed_flight) = {.events = 90, .flown = 10};
  count_of(report, Kind::missed_flight, Condition::dead) = {.events = 50, .detected = 9, .controlling = 3, .flown = 2};
  EXPECT_EQ(known_limits(report).size(), 1U);
  EXPECT_TRUE(says(report,
                   "tasha3_launch2: false actuations 3 (at most 14.8 %) in 50 recoveries with one accelerometer bad, "
                   "after a flight that was not controlled"));
  EXPECT_TRUE(says(report, "false actuations 0 (at most 1.6 %) in 190 events with both accelerometers well"));
  EXPECT_NE(page_of(report).find("missed_flight: not counted, because this plan controls them as it should: 12"),
            std::string::npos);
  EXPECT_NE(page_of(report).find("10 more controlled as they should be"), std::string::npos);
}

TEST(DetectionVerdict, TheWorstKindAndItsBoundStandBesideThePooledOne) {
  Report report = of("tasha3_launch2", {Kind::shaking, Kind::chuff, Kind::gust});
  count_of(report, Kind::shaking) = {.events = 100};
  count_of(report, Kind::chuff) = {.events = 100};
  count_of(report, Kind::chuff).worst.value = 0.9F;
  count_of(report, Kind::gust) = {.events = 800};
  EXPECT_TRUE(says(report,
                   "false actuations 0 (at most 0.3 %) in 1000 events with both accelerometers well; of the "
                   "worst kind alone, chuff, 0 (at most 3 %) in 100"));
  EXPECT_NE(
      page_of(report).find(
          "tasha3_launch2: of the worst kind, chuff, 0 (at most 3 %) of 100; of all kinds together 0 (at most 0.3 %)."),
      std::string::npos);
  const Report alone = of("tasha3_launch2", {Kind::shaking});
  EXPECT_EQ(worst_kind_of(alone, 0), std::nullopt) << "one kind is not pooled";
}

TEST(DetectionVerdict, ThatNoEventAtAllMayMoveACanardIsShownByNoBound) {
  Report report = of("tasha3_launch2", {Kind::shaking});
  count_of(report, Kind::shaking) = {.events = 30};
  EXPECT_EQ(verdict(requirements(report)), Verdict::met);
  EXPECT_TRUE(said_of(report)["false_at_most"].is_null());
  report.false_at_most = 0.0;
  EXPECT_EQ(verdict(requirements(report)), Verdict::not_met);
  EXPECT_TRUE(says(report,
                   "false actuations 0 (at most 9.6 %) in 30 events with both accelerometers well, and at most "
                   "0 % of all kinds together asked for"));
  EXPECT_EQ(said_of(report)["false_at_most"], 0.0);
}

TEST(DetectionVerdict, OfAHandfulOfEventsNothingIsJudgedUnlessOneOfThemMovedACanard) {
  Report report = of("tasha3_launch2", {Kind::shaking});
  count_of(report, Kind::shaking) = {.events = 1};
  EXPECT_EQ(verdict(requirements(report)), Verdict::not_judged);
  EXPECT_TRUE(
      says(report, "false actuations 0 (at most 95 %) in 1 events with both accelerometers well: too few to judge"));
  count_of(report, Kind::shaking).controlling = 1;
  EXPECT_EQ(verdict(requirements(report)), Verdict::not_met);
}

TEST(DetectionVerdict, NothingIsAskedOfARuleThatIsShown) {
  Report report = of(published_launch_2, {Kind::shaking, Kind::launch});
  report.at_most = 0.1;
  count_of(report, Kind::shaking) = {.events = 100, .detected = 9, .controlling = 3};
  EXPECT_EQ(verdict(requirements(report)), Verdict::not_judged);
  EXPECT_FALSE(judges_launches(report.campaign));
  EXPECT_FALSE(judges_events(report.campaign));
  EXPECT_NE(page_of(report).find("No plan was played that is judged."), std::string::npos);
}

TEST(DetectionVerdict, IsOfLaunchesOnlyWhereThereAreSome) {
  Report report = of("tasha3_launch2", {Kind::launch, Kind::shaking});
  EXPECT_TRUE(judges_launches(report.campaign));
  EXPECT_TRUE(judges_events(report.campaign));
  report.campaign.launches = 0;
  EXPECT_FALSE(judges_launches(report.campaign));
  report.campaign.events = 0;
  EXPECT_FALSE(judges_events(report.campaign));
  EXPECT_FALSE(judges_launches(of("tasha3_launch2", {Kind::launch_one_bad, Kind::shaking}).campaign));
}

TEST(DetectionVerdict, KindsOfWhichThereIsToBeNoneAreLeftOut) {
  Campaign campaign = of("tasha3_launch2", {Kind::launch, Kind::shaking}).campaign;
  campaign.launches = 0;
  campaign.drop_empty_kinds();
  EXPECT_EQ(campaign.kinds, std::vector<Kind>{Kind::shaking});
  campaign.events = 0;
  campaign.drop_empty_kinds();
  EXPECT_TRUE(campaign.kinds.empty());
}

TEST(DetectionVerdict, OfTheShippedPlansThoseThatAskTwoAccelerometersAreJudgedAndANamedOneAlways) {
  for (const Rule& rule : rules_of({})) {
    EXPECT_EQ(rule.judged, rule.names.front() == "tasha3_launch2") << rule.name();
  }
  const std::array<std::string, 1> first{"tasha3_launch1"};
  EXPECT_TRUE(rules_of(first).front().judged);
}

TEST(DetectionVerdict, TheCommandOfAnEventHasItsSeedAndThePlansThatWereAskedFor) {
  Campaign campaign{.rules = {}, .kinds = {Kind::shaking}};
  EXPECT_EQ(command_of(campaign, Kind::shaking, 12), "fantail campaign detection --kind shaking --event 12");
  campaign.seed = 7;
  campaign.plans = {"tasha3_launch2", "my plan.toml"};
  EXPECT_EQ(
      command_of(campaign, Kind::shaking, 12),
      "fantail campaign detection --kind shaking --event 12 --seed 7 --plan tasha3_launch2 --plan 'my plan.toml'");
}

}  // namespace
}  // namespace fantail::detection
