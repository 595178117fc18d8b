// SPDX-License-Identifier: MIT
// Stored parts: whose they are, and that they are what was stored. And what a campaign is refused for before it flies.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <future>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "faults/parts.hpp"
#include "faults/results.hpp"
#include "input/scenario_file.hpp"
#include "text/error.hpp"

namespace fantail::faults {
namespace {

namespace fs = std::filesystem;

const auto unseen = [](std::uint64_t) {};

Campaign switches() {
  Campaign campaign;
  campaign.scenario = "tasha3_launch2";
  campaign.device = "arm_switch";
  campaign.phase = "launched";
  campaign.every = 1000;
  return campaign;
}

std::string text_in(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream{file}.rdbuf();
  return text.str();
}

std::string refusal_of(const auto& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing was refused";
}

class FaultParts : public testing::Test {
 protected:
  FaultParts() : folder_{fs::temp_directory_path() / ("fantail_fault_parts_" + std::to_string(getpid()))} {
    fs::remove_all(folder_);
    whole_ = fly();
    for (const auto& file : fs::directory_iterator{folder_ / "parts"}) {
      parts_.push_back(file.path());
    }
    std::ranges::sort(parts_);
  }
  ~FaultParts() override { fs::remove_all(folder_); }

  [[nodiscard]] Result fly(std::uint64_t seed = 1) const {
    Campaign campaign = switches();
    campaign.seed = seed;
    return fly_campaign(campaign, folder_, "1 (a)", 2, unseen);
  }
  void expect_flown_again(std::uint64_t damaged) const {
    const Result again = fly();
    EXPECT_EQ(again.damaged, damaged);
    EXPECT_EQ(report_json(again, "1"), report_json(whole_, "1"));
    EXPECT_EQ(fly().damaged, 0U);
  }

  fs::path folder_;
  Result whole_;
  std::vector<fs::path> parts_;
};

TEST_F(FaultParts, OneWhoseOutcomeWasChangedIsFlownAgainAndCounted) {
  std::string text = text_in(parts_.at(0));
  const std::size_t digit =
      text.find(",no_control,") != std::string::npos ? text.find(",no_control,") + 1 : text.find("holds");
  ASSERT_NE(digit, std::string::npos) << text;
  text.replace(digit, text.find(',', digit) - digit, "over");
  std::ofstream{parts_[0]} << text;
  expect_flown_again(1);
}

TEST_F(FaultParts, OneThatWasCopiedOverAnotherIsFlownAgain) {
  fs::copy_file(parts_.at(0), parts_.at(1), fs::copy_options::overwrite_existing);
  expect_flown_again(1);
}

TEST_F(FaultParts, ThoseOfAnotherSeedAreNone) {
  fs::remove(folder_ / "faults.json");
  const Result other = fly(7);
  EXPECT_EQ(other.damaged, parts_.size());
  EXPECT_EQ(other.cells.at(0).worst->seed, 7U);
}

TEST_F(FaultParts, AnotherProgramIsAnotherCampaign) {
  const std::string said = refusal_of([&] { (void)fly_campaign(switches(), folder_, "1 (b)", 2, unseen); });
  EXPECT_NE(
      said.find(": choose another folder with --out, or remove this one; it holds another campaign: version is 1 (a) "
                "there and 1 (b) here"),
      std::string::npos)
      << said;
}

TEST_F(FaultParts, AFolderOfAnotherKindOfCampaignIsRefused) {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  std::ofstream{folder_ / "parts.jsonl"} << "";
  EXPECT_NE(refusal_of([&] { (void)fly(); }).find("parts.jsonl of fantail campaign detection"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "faults.json"));
}

TEST_F(FaultParts, OneThatIsAFolderIsNamed) {
  fs::remove(parts_.at(0));
  fs::create_directory(parts_[0]);
  EXPECT_EQ(refusal_of([&] { (void)fly(); }), parts_[0].string() + ": is a folder, and no place for a file");
}

TEST_F(FaultParts, OfTwoCampaignsThatBeginAtOnceInANewFolderOneIsRefused) {
  for (int round = 0; round < 20; ++round) {
    fs::remove_all(folder_);
    const auto is_refused = [this](const char* seed) {
      try {
        const PartsFolder folder{folder_, {{"seed", seed}}};
      } catch (const text::Error&) {
        return true;
      }
      return false;
    };
    auto other = std::async(std::launch::async, is_refused, "2");
    const bool one = is_refused("1");
    ASSERT_NE(one, other.get()) << round;
  }
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
  Campaign campaign = switches();
  const Alone limit = fly_alone(campaign, "imu/offset_100/controlling", 0);
  EXPECT_EQ(limit.judged.colour, Colour::known_limit);
  const std::string text = run_text(limit, "r");
  EXPECT_NE(text.find("imu/offset_100/controlling, run 0: a known limit\n"), std::string::npos) << text;
  EXPECT_NE(text.find("to do:   fly on two gyros"), std::string::npos) << text;
  EXPECT_NE(run_json(campaign, limit, "r", "1").find("\"result\": \"known limit\""), std::string::npos);
  const Alone all = fly_alone(campaign, "servo/all_dead/controlling", 0);
  EXPECT_EQ(all.judged.colour, Colour::not_judged);
  EXPECT_NE(run_text(all, "r").find("run 0: not judged further\n"), std::string::npos);
  EXPECT_NE(run_text(fly_alone(campaign, "bus/dead/launched", 0), "r").find("run 0: safe\n"), std::string::npos);
}

TEST(FaultAlone, IsNotJudgedFurtherWhereTheWholeCellIsNot) {
  const Cell cell = cell_of("servo/all_dead/controlling");
  const faults::Run spun{.outcome = Outcome::anything, .apart_deg = 777.0};
  Result result;
  result.cells = {concluded(cell, {spun}, {})};
  EXPECT_EQ(result.cells[0].colour, Colour::not_judged);
  EXPECT_FALSE(has_red(result));
  EXPECT_NE(headline(result).find(" Not judged beyond what holds for every flight: 1 cell."), std::string::npos);
  EXPECT_NE(report_html(result, "1").find("not judged further, 1"), std::string::npos);
  EXPECT_NE(report_json(result, "1").find("\"not_judged\": 1"), std::string::npos);
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
  EXPECT_NE(
      headline(result).find(" Not safe, for a limit that is known: 2 cells, at worst servo/garbage/controlling (714 "
                            "deg off)."),
      std::string::npos)
      << headline(result);
  const std::string amber = report_html(result, "1");
  EXPECT_NE(amber.find("class=\"verdict unsure\""), std::string::npos);
  EXPECT_EQ(amber.find("No red cell"), std::string::npos);
  result.cells.push_back(concluded(cell_of("servo/dead/controlling"), {red(100.0)}, {}));
  EXPECT_NE(headline(result).find(" RED: 1 cell, at worst servo/dead/controlling (100 deg off)."), std::string::npos);
  EXPECT_NE(report_html(result, "1").find("class=\"verdict bad\""), std::string::npos);
  result.cells = {concluded(cell_of("servo/dead/controlling"), {faults::Run{.outcome = Outcome::holds}}, {})};
  EXPECT_NE(report_html(result, "1").find("class=\"verdict good\""), std::string::npos);
}

}  // namespace
}  // namespace fantail::faults
