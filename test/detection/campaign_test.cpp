// SPDX-License-Identifier: MIT
#include "detection/campaign.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "detection/report.hpp"
#include "figures.hpp"
#include "json/value.hpp"
#include "runs/folder.hpp"
#include "text/error.hpp"

namespace fantail::detection {
namespace {

namespace fs = std::filesystem;

const auto look_away = [](std::uint64_t) {};

Campaign small() {
  Campaign campaign{.rules = rules_of({}), .kinds = {Kind::shaking, Kind::drop, Kind::launch}};
  campaign.events = 300;
  campaign.launches = 60;
  return campaign;
}

/// As if its guide were a hand's breadth long: then a shake moves canards.
void let_control_begin_at_once(Rule& rule) {
  rule.plan.guide.length_m = 0.1F;
  rule.plan.guide.clearance_m = 0.0F;
}

/// The rest of the line, from where these words stand first.
std::string line_from(const std::string& text, const std::string& words) {
  const std::size_t begin = text.find(words);
  return begin == std::string::npos ? "" : text.substr(begin, text.find('\n', begin) - begin);
}

class DetectionCampaign : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_ =
      fs::temp_directory_path() /
      ("fantail_detection_" + std::string{testing::UnitTest::GetInstance()->current_test_info()->name()});
};

void expect_equal(const Results& a, const Results& b) {
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    EXPECT_EQ(a.of_kind[kind] == b.of_kind[kind], true) << kind_table[kind].name;
  }
}

TEST_F(DetectionCampaign, HasTheSameCountsWithAnyNumberOfThreads) {
  expect_equal(play(small(), std::nullopt, "1", 1, look_away), play(small(), std::nullopt, "1", 3, look_away));
}

TEST_F(DetectionCampaign, CountsEveryEventOnce) {
  const Results results = play(small(), std::nullopt, "1", 2, look_away);
  for (const Kind kind : small().kinds) {
    for (const auto& rule : results.of_kind[index(kind)]->of_rule) {
      std::uint64_t events = 0;
      for (const Count& count : rule) {
        events += count.events;
      }
      EXPECT_EQ(events, small().number_of(kind));
    }
  }
  EXPECT_FALSE(results.of_kind[index(Kind::gust)]);
}

TEST_F(DetectionCampaign, GoesOnWhereItWasInterruptedAndAPartThatWasCutIsPlayedAgainAndCounted) {
  const Results whole = play(small(), folder_, "1", 1, look_away);
  EXPECT_EQ(whole.damaged, 0U);
  const fs::path part = folder_ / "parts/launch.00000000.part";
  fs::resize_file(part, fs::file_size(part) - 40);
  const Results again = play(small(), folder_, "1", 2, look_away);
  expect_equal(whole, again);
  EXPECT_EQ(again.played, 60U);
  EXPECT_EQ(again.damaged, 1U);
  Campaign more = small();
  more.launches = 70;
  const Results third = play(more, folder_, "1", 2, look_away);
  EXPECT_EQ(third.played, 70U) << "the kinds of which no more are wanted are as they were";
  EXPECT_EQ(third.damaged, 0U);
}

TEST_F(DetectionCampaign, PartsThatOtherModelsOrAnotherLawHaveMadeAreRefused) {
  (void)play(small(), folder_, "1", 1, look_away);
  Campaign other = small();
  const std::string before = fingerprint(other.rules);
  EXPECT_EQ(fingerprint(other.rules), before);
  // As if the law had changed: the plan is another one, by a field that is no part of its rule's text.
  other.rules[0].plan.run.overrun_limit = 0;
  EXPECT_EQ(fingerprint(other.rules), before);
  other.rules[0].plan.guide.length_m += 0.5F;
  EXPECT_NE(fingerprint(other.rules), before);
  std::stringstream content;
  content << std::ifstream{folder_ / "parts/identity.json"}.rdbuf();
  std::string text = content.str();
  const std::size_t digest = text.find(runs::short_digest(before));
  ASSERT_NE(digest, std::string::npos);
  text[digest] = text[digest] == '0' ? '1' : '0';
  std::ofstream{folder_ / "parts/identity.json"} << text;
  EXPECT_THROW((void)play(small(), folder_, "1", 1, look_away), text::Error);
}

TEST_F(DetectionCampaign, OfAnotherSeedProgramOrSetOfEventsIsRefusedByWhatDiffers) {
  (void)play(small(), folder_, "1 (a)", 1, look_away);
  const auto refusal = [this](const Campaign& campaign, const char* program) -> std::string {
    try {
      (void)play(campaign, folder_, program, 1, look_away);
    } catch (const text::Error& error) {
      EXPECT_EQ(error.kind(), text::ErrorKind::bad_configuration);
      return error.what();
    }
    return "it was played";
  };
  Campaign other = small();
  other.seed = 2;
  EXPECT_TRUE(refusal(other, "1 (a)").ends_with("it holds another campaign: seed is 1 there and 2 here"));
  EXPECT_TRUE(refusal(small(), "1 (b)").ends_with("program is 1 (a) there and 1 (b) here"));
  other = small();
  other.both_well = true;
  EXPECT_TRUE(refusal(other, "1 (a)").ends_with("both_well is no there and yes here"));
}

TEST_F(DetectionCampaign, OfBothWellEveryEventIs) {
  Campaign campaign = small();
  campaign.both_well = true;
  const Results results = play(campaign, std::nullopt, "1", 2, look_away);
  EXPECT_EQ(results.of_kind[index(Kind::drop)]->of_rule[0][0].events, 300U);
  EXPECT_EQ(campaign.event(Kind::drop, 7), 14U);
  EXPECT_EQ(campaign.event(Kind::launch, 7), 7U);
}

TEST_F(DetectionCampaign, OfNoneThereIsAReportAllTheSame) {
  Campaign campaign = small();
  campaign.launches = 0;
  campaign.events = 0;
  const Report report{.campaign = campaign, .results = play(campaign, std::nullopt, "1", 2, look_away), .at_most = 0.0};
  EXPECT_TRUE(failures(report).empty());
  const std::string text = result::text(answer(report));
  EXPECT_EQ(figures(line_from(text, "tasha3_launch1: 0 ")), std::vector<std::string>(9, "0")) << text;
  EXPECT_NO_THROW((void)result::json(answer(report)));
  EXPECT_NE(result::html(answer(report)).find("<html"), std::string::npos);
}

TEST_F(DetectionCampaign, TheReportSaysWhichJudgedPlanMovedACanard) {
  const std::vector<std::string> names{"tasha3_launch1", "tasha3_launch2", published_launch_2};
  Campaign campaign = small();
  campaign.rules = rules_of(names);
  let_control_begin_at_once(campaign.rules.back());
  Report report{.campaign = campaign, .results = play(campaign, std::nullopt, "1", 2, look_away), .at_most = 0.0};
  std::uint64_t of_published = 0;
  for (std::size_t rule = 0; rule < report.campaign.rules.size(); ++rule) {
    const Sum events = events_of(report.results, rule);
    of_published += report.campaign.rules[rule].judged ? 0 : events.controlling;
  }
  EXPECT_GT(of_published, 0U);  // and nobody is blamed for it
  for (const std::string& failure : failures(report)) {
    EXPECT_EQ(failure.find(published_launch_2), std::string::npos) << failure;
  }
  // The first launch's rule misses launches at vibration, so it is named once for each.
  EXPECT_FALSE(failures(report).empty());
  report.at_most = 1.0;
  for (const std::string& failure : failures(report)) {
    EXPECT_EQ(failure.find("missed"), std::string::npos) << failure;
  }
  const std::string text = result::text(answer(report));
  const std::vector<std::string> counts = figures(line_from(text, "tasha3_launch1: 300 "));
  ASSERT_GE(counts.size(), 9U) << text;
  EXPECT_EQ(counts[6], "60") << "launches; " << text;
  const json::Value said = json::parse(result::json(answer(report)));
  EXPECT_EQ(said["rules"][0]["rows"][0]["kind"], "shaking");
  EXPECT_FALSE(known_limits(report).empty()) << "most shakes in which its accelerometer is stuck";
  EXPECT_EQ(said["known_limits"].size(), known_limits(report).size());
  EXPECT_NE(result::html(answer(report)).find("<svg"), std::string::npos);
}

// All of the models through the shipped plan of the second launch, both accelerometers well: what docs/devices.md
// says of 10^7 events, in the small.
TEST_F(DetectionCampaign, NoneOfAHundredThousandEventsMovesACanardOfTheSecondLaunchWhenBothAccelerometersAreWell) {
  const std::vector<std::string> names{"tasha3_launch2"};
  Campaign campaign{.rules = rules_of(names), .kinds = {}};
  for (std::size_t kind = 0; kind < index(Kind::launch); ++kind) {
    campaign.kinds.push_back(static_cast<Kind>(kind));
  }
  campaign.both_well = true;
  campaign.events = 9'091;
  EXPECT_GT(campaign.total(), 100'000U);
  const Results results = play(campaign, std::nullopt, "1", 2, look_away);
  for (const Kind kind : campaign.kinds) {
    const Count& well = results.of_kind[index(kind)]->of_rule[0][0];
    EXPECT_EQ(well.events, 9'091U);
    EXPECT_EQ(well.controlling, 0U) << info(kind).name;
  }
}

TEST_F(DetectionCampaign, TheChartOfBoundsHasABarForEachRuleOfEachKindOfEvent) {
  const Report report{.campaign = small(), .results = play(small(), std::nullopt, "1", 2, look_away)};
  const std::string svg = bounds_svg(report, 880.0);
  std::size_t bars = 0;
  for (std::size_t at = 0; (at = svg.find("<title>", at)) != std::string::npos; ++at) {
    ++bars;
  }
  EXPECT_EQ(bars, 2 * report.campaign.rules.size());
  EXPECT_NE(svg.find(">drop</text>"), std::string::npos);
  EXPECT_EQ(svg.find(">launch</text>"), std::string::npos);
  Report launches = report;
  launches.campaign.kinds = {Kind::launch};
  EXPECT_EQ(bounds_svg(launches, 880.0), "");
}

TEST(ShownEventOfACampaign, HasTheAnswerThatWasCounted) {
  Campaign campaign = small();
  let_control_begin_at_once(campaign.rules.back());
  Rehearsal rehearsal{campaign.rules};
  for (std::uint64_t event = 0; event < 300; ++event) {
    const std::vector<Answer> answers = rehearsal.play(campaign.seed, Kind::shaking, event);
    if (answers.back().controlling) {
      const ShownEvent shown = show_event(campaign, Kind::shaking, event);
      const result::Document document = event_answer(campaign, Kind::shaking, event, {});
      const std::string text = result::text(document);
      EXPECT_NE(text.find("the canards move"), std::string::npos) << text;
      EXPECT_NE(text.find("range of the"), std::string::npos) << text;
      EXPECT_LT(text.find("control may begin"), text.find("% of the gate")) << text;
      EXPECT_NE(shown.verdict.find("not a launch"), std::string::npos) << shown.verdict;
      const std::string page = result::html(document);
      EXPECT_LT(page.find(shown.verdict.substr(0, shown.verdict.find(". "))), page.find("<svg"));
      for (const char* const line :
           {"threshold of tasha3_launch1", "control by published_launch2", "gate of kestrel ..."}) {
        EXPECT_NE(page.find(line), std::string::npos) << line;
      }
      return;
    }
  }
  FAIL() << "no shaking event of 300 moves a canard by the printed rule";
}

}  // namespace
}  // namespace fantail::detection
