// SPDX-License-Identifier: MIT
// What a campaign is refused for before it flies, and what a run alone says.
#include <gtest/gtest.h>

#include "faults/results.hpp"
#include "figures.hpp"
#include "switches.hpp"
#include "text/error.hpp"

namespace fantail::faults {
namespace {

std::string refusal_of(const auto& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(FaultExtent, OfAnAbortInputNeedsAPlanThatFitsOne) {
  Campaign campaign;
  campaign.scenario = "tasha3_launch2";
  campaign.device = "abort_input";
  const std::string said = refusal_of([&] { (void)extent_of(campaign); });
  EXPECT_NE(said.find("the plan fits no abort input (run.abort_input)"), std::string::npos) << said;
}

TEST(FaultExtent, TooManyFlightsAreRefusedBeforeTheyAreListed) {
  Campaign campaign;
  campaign.scenario = "tasha3_launch2";
  campaign.every = 1;
  campaign.step_ms = 1;
  campaign.seeds = 10'000;
  const std::string said = refusal_of([&] { (void)extent_of(campaign); });
  EXPECT_NE(said.find(" flights; allowed: 10000000; take fewer seeds"), std::string::npos) << said;
}

TEST(FaultExtent, WhoInterruptsTheFlightsWithoutFaultsEndsThem) {
  Campaign campaign = switches();
  campaign.seeds = 3'000;
  struct Stop {};
  EXPECT_THROW((void)prepare(campaign, 2, [](std::size_t) { throw Stop{}; }), Stop);
}

TEST(FaultNames, WordsOfTheCommandLineThatAreNoneAreWrongUsage) {
  for (const auto& [device, fault] : {std::pair{"bar", ""}, std::pair{"imu", "foo"}, std::pair{"", "foo"}}) {
    Campaign campaign = switches();
    campaign.device = device;
    campaign.fault = fault;
    try {
      (void)extent_of(campaign);
      FAIL() << device << " " << fault;
    } catch (const text::Error& error) {
      EXPECT_EQ(error.kind(), text::ErrorKind::usage) << error.what();
    }
  }
  try {
    (void)fly_alone(switches(), "arm_switch/open/launched", 1'000'000);
    FAIL() << "it flew";
  } catch (const text::Error& error) {
    EXPECT_EQ(error.kind(), text::ErrorKind::usage) << error.what();
  }
}

TEST(FaultAlone, APlanThatEndsControlForACanardIsSafeWhereItDoesAndNotWhereThePlanSaysToGoOn) {
  Campaign campaign;
  campaign.scenario = "kestrel_euroc";
  campaign.every = 3'000;
  const Alone ended = fly_alone(campaign, "servo/dead/controlling", 0);
  EXPECT_EQ(ended.run.outcome, Outcome::ended) << ended.run.what;
  EXPECT_NE(sentence(ended.expected)
                .find("no control, or held within 10 deg, or control ended early, and held within 60 deg until then"),
            std::string::npos)
      << sentence(ended.expected);
  EXPECT_EQ(fly_alone(campaign, "servo/hardover/launched", 0).run.outcome, Outcome::no_control);
  campaign.changes = {{"run", "canard_fault", "continue"}};
  EXPECT_NE(fly_alone(campaign, "servo/dead/controlling", 0).run.outcome, Outcome::ended);
}

TEST(FaultNames, AFaultThatIsNoneIsAnsweredWithThoseThatThereAre) {
  Campaign campaign = switches();
  campaign.fault = "foo";
  EXPECT_NE(
      refusal_of([&] { (void)extent_of(campaign); }).find("there is no fault \"foo\" of device arm_switch; allowed: "),
      std::string::npos);
  campaign.device = "bar";
  EXPECT_NE(refusal_of([&] { (void)extent_of(campaign); }).find("there is no device \"bar\"; allowed: imu, "),
            std::string::npos);
}

TEST(FaultAlone, HasTheVerdictOfTheCampaignAndSaysWhy) {
  const Campaign campaign = switches();
  const auto said_of = [&](const Alone& alone) { return json::parse(result::json(answer(campaign, alone, "r"))); };
  const Alone limit = fly_alone(campaign, "imu/offset_100/controlling", 0);
  EXPECT_EQ(limit.judged.colour, Colour::known_limit);
  const json::Value said = said_of(limit);
  EXPECT_EQ(said["cell"], "imu/offset_100/controlling");
  EXPECT_EQ(said["run"], 0);
  EXPECT_EQ(said["result"], "known limit");
  EXPECT_EQ(said["answer"], "undecided");
  const std::string what_to_do = said["limit"]["what_to_do"].text();
  EXPECT_NE(what_to_do.find("two gyros"), std::string::npos) << said;
  const std::string text = result::text(answer(campaign, limit, "r"));
  EXPECT_NE(text.find(what_to_do), std::string::npos) << text;
  const Alone all = fly_alone(campaign, "servo/all_dead/controlling", 0);
  EXPECT_EQ(said_of(all)["result"], "not judged further");
  EXPECT_EQ(said_of(fly_alone(campaign, "bus/dead/launched", 0))["answer"], "yes");
}

TEST(FaultAlone, IsNotJudgedFurtherWhereTheWholeCellIsNot) {
  const Cell cell = cell_of("servo/all_dead/controlling");
  const faults::Run spun{.outcome = Outcome::anything, .apart_deg = 777.0};
  Result result;
  result.cells = {concluded(cell, {spun}, {})};
  EXPECT_EQ(result.cells[0].colour, Colour::not_judged);
  EXPECT_FALSE(has_red(result));
  EXPECT_EQ(figures(headline(result)), (std::vector<std::string>{"0", "1", "1"})) << "flights, cells, and not judged";
  EXPECT_NE(result::html(answer(result)).find("not judged further, 1"), std::string::npos);
  EXPECT_EQ(json::parse(result::json(answer(result)))["not_judged"], 1);
}

TEST(FaultHeadline, OfAKnownLimitTheBarIsAmberAndTheWorstCellIsNamed) {
  const KnownLimit limit{.recipe = hardover, .phases = 0, .with_one_gyro = false, .why = "w", .what_to_do = "d"};
  const auto red = [](double apart_deg) {
    return faults::Run{.apart_deg = apart_deg,
                       .what = std::to_string(static_cast<int>(apart_deg)) + " deg off; and more"};
  };
  Result result;
  result.cells = {concluded(cell_of("servo/hardover/controlling"), {red(645.0)}, {&limit}),
                  concluded(cell_of("servo/garbage/controlling"), {red(714.0)}, {&limit})};
  EXPECT_EQ(figures(headline(result)), (std::vector<std::string>{"2", "2", "0", "2", "2", "714"})) << headline(result);
  EXPECT_NE(headline(result).find("servo/garbage/controlling"), std::string::npos) << headline(result);
  EXPECT_EQ(answer_of(result), result::Answer::undecided);
  EXPECT_EQ(result::html(answer(result)).find("No red cell"), std::string::npos);
  result.cells.push_back(concluded(cell_of("servo/dead/controlling"), {red(100.0)}, {}));
  EXPECT_EQ(figures(headline(result)), (std::vector<std::string>{"3", "3", "0", "3", "1", "100", "2", "714"}));
  EXPECT_NE(headline(result).find("servo/dead/controlling"), std::string::npos) << headline(result);
  EXPECT_EQ(answer_of(result), result::Answer::no);
  result.cells = {concluded(cell_of("servo/dead/controlling"), {faults::Run{.outcome = Outcome::holds}}, {})};
  EXPECT_EQ(answer_of(result), result::Answer::yes);
}

}  // namespace
}  // namespace fantail::faults
