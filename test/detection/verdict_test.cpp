// SPDX-License-Identifier: MIT
// What is asked of a rule, and what the report says came of it.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "detection/report.hpp"
#include "figures.hpp"

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

/// The numbers of this sentence, which stands in every output.
Numbers figures_said(const Report& report, const std::string& sentence) {
  EXPECT_TRUE(says(report, sentence)) << sentence;
  return figures(sentence);
}
/// Of the sentence of the first judged plan.
Numbers first_required(const Report& report) { return figures_said(report, requirements(report).at(0).sentence); }

std::string page_of(const Report& report) { return result::html(answer(report)); }
/// Does one sentence of the page have this word, and these numbers one behind the other?
bool page_says(const Report& report, const std::string& word, const Numbers& numbers) {
  std::istringstream page{page_of(report)};
  for (std::string piece; std::getline(page, piece, '<');) {
    const Numbers all = figures(piece);
    if (piece.find(word) != std::string::npos && !std::ranges::search(all, numbers).empty()) {
      return true;
    }
  }
  return false;
}
json::Value said_of(const Report& report) { return json::parse(result::json(answer(report))); }

TEST(DetectionVerdict, MissedLaunchesAreJudgedByTheBoundAndNotByWhatWasSeen) {
  Report report = of("tasha3_launch2", {Kind::launch});
  report.at_most = 0.001;
  count_of(report, Kind::launch) = {.events = 5, .detected = 5, .controlling = 5};
  EXPECT_EQ(verdict(requirements(report)), Verdict::not_met);
  EXPECT_EQ(figures_said(report, failures(report).at(0)), (Numbers{"0", "45.1", "5", "0.1"}));
  EXPECT_TRUE(says(report, "more launches"));
  count_of(report, Kind::launch) = {.events = 3'000, .detected = 3'000, .controlling = 3'000};
  EXPECT_EQ(verdict(requirements(report)), Verdict::met);
  count_of(report, Kind::launch).detected = 2'996;
  EXPECT_EQ(verdict(requirements(report)), Verdict::not_met);
  EXPECT_FALSE(says(report, "more launches"));
  report.at_most = 1.0;
  EXPECT_EQ(verdict(requirements(report)), Verdict::met);
}

TEST(DetectionVerdict, OfLaunchesAloneNothingIsSaidAboutFalseActuations) {
  Report report = of("tasha3_launch2", {Kind::launch});
  count_of(report, Kind::launch) = {.events = 5, .detected = 5, .controlling = 5};
  EXPECT_EQ(verdict(requirements(report)), Verdict::not_judged);
  EXPECT_EQ(requirements(report).at(0).verdict, Verdict::not_judged);
  EXPECT_EQ(first_required(report), Numbers{});
  EXPECT_EQ(page_of(report).find("moved a canard"), std::string::npos);
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
  EXPECT_EQ(first_required(report), (Numbers{"0", "1", "300", "0", "3", "100"})) << "pooled, and shaking alone";
  const Numbers limit = figures_said(report, known_limits(report).at(0));
  EXPECT_EQ((Numbers{limit.begin(), limit.begin() + 3}), (Numbers{"3", "14.8", "50"}));
  EXPECT_TRUE(says(report, "stands still"));
  EXPECT_TRUE(page_says(report, "moved a canard", {"300", "2"}));
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
  const std::string limit = known_limits(report)[0];
  EXPECT_EQ(figures_said(report, limit), (Numbers{"3", "14.8", "50"}));
  EXPECT_TRUE(limit.starts_with("tasha3_launch2") && limit.find("recoveries") != std::string::npos) << limit;
  EXPECT_EQ(first_required(report), (Numbers{"0", "1.6", "190", "0", "3.3", "90"}));
  EXPECT_TRUE(page_says(report, "missed_flight", {"12"}));
  EXPECT_NE(page_of(report).find("10 more"), std::string::npos);
}

TEST(DetectionVerdict, TheWorstKindAndItsBoundStandBesideThePooledOne) {
  Report report = of("tasha3_launch2", {Kind::shaking, Kind::chuff, Kind::gust});
  count_of(report, Kind::shaking) = {.events = 100};
  count_of(report, Kind::chuff) = {.events = 100};
  count_of(report, Kind::chuff).worst.value = 0.9F;
  count_of(report, Kind::gust) = {.events = 800};
  EXPECT_EQ(first_required(report), (Numbers{"0", "0.3", "1000", "0", "3", "100"}));
  EXPECT_EQ(worst_kind_of(report, 0), Kind::chuff);
  EXPECT_NE(requirements(report).at(0).sentence.find("chuff"), std::string::npos);
  EXPECT_TRUE(page_says(report, "chuff", {"0", "3", "100", "0", "0.3"}));
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
  EXPECT_EQ(first_required(report), (Numbers{"0", "9.6", "30", "0"}));
  EXPECT_EQ(said_of(report)["false_at_most"], 0.0);
}

TEST(DetectionVerdict, OfAHandfulOfEventsNothingIsJudgedUnlessOneOfThemMovedACanard) {
  Report report = of("tasha3_launch2", {Kind::shaking});
  count_of(report, Kind::shaking) = {.events = 1};
  EXPECT_EQ(verdict(requirements(report)), Verdict::not_judged);
  EXPECT_EQ(first_required(report), (Numbers{"0", "95", "1"}));
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
  EXPECT_TRUE(requirements(report).empty());
  EXPECT_NE(page_of(report).find("No plan"), std::string::npos);
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
    EXPECT_EQ(rule.judged, rule.names.front() == "tasha3_launch2" || rule.names.front() == "kestrel") << rule.name();
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
