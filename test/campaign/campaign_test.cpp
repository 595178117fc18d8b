// SPDX-License-Identifier: MIT
#include "campaign/campaign.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "campaign/runs_file.hpp"
#include "figures.hpp"
#include "fly/fly_scenario.hpp"
#include "input/scratch_file.hpp"
#include "report/figures.hpp"
#include "text/deflate.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"

namespace fantail::campaign {
namespace {

namespace fs = std::filesystem;

const auto look_away = [](std::uint64_t) {};

std::string content(const fs::path& file) {
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

/// The second launch with two unknown quantities, in a folder of its own. More runs than a part has.
/// What a remark says behind the name of this file.
std::string said_of(const fs::path& file, const std::string& remark) {
  EXPECT_TRUE(remark.starts_with(file.string() + ": ")) << remark;
  return remark.substr(std::min(remark.size(), file.string().size()));
}

class ACampaign : public testing::Test {
 protected:
  static constexpr const char* usual_spreads =
      "[[spread]]\nfield = \"aerodynamics.torque_m\"\nlaw = \"normal\"\nstandard_deviation = 2\n"
      "[[spread]]\nfield = \"disturbance.angles_deg\"\nlaw = \"uniform\"\neffect = \"offset\"\nlow = -3\nhigh = 3\n";

  explicit ACampaign(const std::string& spreads = usual_spreads)
      : file{"vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n"
             "[disturbance]\ntimes_s = [0]\nangles_deg = [-4.9]\n" +
                 spreads,
             "scenario.toml"},
        folder{file.path().parent_path()},
        asked{.scenario = file.path().string(), .changes = {}, .seed = 5, .runs = runs_of_a_part + 3} {}

  std::vector<FlownRun> fly(const char* name, unsigned threads = 2,
                            const std::function<void(std::uint64_t)>& look = look_away) const {
    return fly_campaign(asked, folder / name, "test", threads, look).runs;
  }
  [[nodiscard]] std::string refusal(const char* name) const {
    try {
      (void)fly(name);
    } catch (const text::Error& error) {
      return error.what();
    }
    return "it was flown";
  }

  input::ScratchFile file;
  fs::path folder;
  Campaign asked;
};

TEST_F(ACampaign, NotesTheRunsWhoseControlBeganInTheLaunchGuide) {
  asked.runs = 2;
  asked.changes = {input::Override{"launch_guide", "length_m", "12"}};
  for (const FlownRun& run : fly("long_guide")) {
    EXPECT_TRUE(run.note.starts_with(begun_on_guide_note)) << run.note;
  }
}

TEST(JudgedFlight, HasOneTimeOfCapture) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.plan.dormancy.until = core::DormantUntil::max_dynamic_pressure;
  scenario.plan.controller.entry = core::ControlEntry::capture;
  scenario.plan.excitation.form = core::ExcitationForm::none;
  const JudgedFlight flown = fly_and_judge(scenario);
  EXPECT_GT(flown.opening.value().captured_after_s.value(), 0.0);
  EXPECT_NEAR(*flown.opening->captured_after_s, flown.figures.capture.after_s.value(), 1e-9);
}

TEST_F(ACampaign, IsTheSameBytesWithEveryNumberOfThreadsAndAfterAnInterruption) {
  const auto runs = fly("one", 1);
  const std::string bytes = content(folder / "one" / "runs.csv.gz");
  ASSERT_FALSE(bytes.empty());
  fly("three", 3);
  EXPECT_EQ(content(folder / "three" / "runs.csv.gz"), bytes);

  const auto interrupt = [](std::uint64_t done) {
    if (done > 0) {
      throw std::runtime_error{"interrupted"};
    }
  };
  EXPECT_THROW(fly("interrupted", 1, interrupt), std::runtime_error);
  EXPECT_FALSE(fs::exists(folder / "interrupted" / "runs.csv.gz"));
  EXPECT_EQ(fly("interrupted"), runs);
  EXPECT_EQ(content(folder / "interrupted" / "runs.csv.gz"), bytes);

  const auto text = text::gunzip(bytes);
  ASSERT_TRUE(text);
  EXPECT_EQ(std::ranges::count(*text, '\n'), static_cast<std::ptrdiff_t>(asked.runs) + 1);
  EXPECT_TRUE(
      text->starts_with("run,seed,aerodynamics.torque_m,disturbance.angles_deg_offset,drawn_again,outcome,"
                        "largest_hold_error_deg,"))
      << text->substr(0, 200);

  const RepeatedRun again = repeat_run(campaign_in(folder / "three", "test"), 40);
  const report::Figures figures = report::figures(fly::fly_scenario(again.scenario));
  EXPECT_EQ(again.scenario.seed, runs[40].seed);
  EXPECT_EQ(text::degrees(figures.largest_hold_error_rad.value()), runs[40].figures[0]);
  EXPECT_EQ(figures.apogee_m, runs[40].figures[6]);
}

TEST_F(ACampaign, StopsAfterTheSameRunsWithEveryNumberOfThreadsAndIsReadBack) {
  asked.runs = 5 * runs_of_a_part;
  asked.stop = StopRule{.required = 0.9};
  const auto runs = fly("early", 3);
  const std::string bytes = content(folder / "early" / "runs.csv.gz");
  EXPECT_LT(runs.size(), asked.runs);
  EXPECT_EQ(stops_at(*asked.stop, runs), runs.size());
  EXPECT_EQ(fly("one", 1), runs);
  EXPECT_EQ(content(folder / "one" / "runs.csv.gz"), bytes);
  bool flew = false;
  EXPECT_EQ(fly("early", 1, [&](std::uint64_t) { flew = true; }), runs);
  EXPECT_FALSE(flew);
  asked.stop->required = 0.95;
  EXPECT_NE(refusal("early").find("stop is outcome=held decided at 0.9 there and"), std::string::npos)
      << refusal("early");
  asked.shard = {.number = 1, .of = 2};
  EXPECT_NE(refusal("other").find("only as a whole"), std::string::npos) << refusal("other");
}

TEST_F(ACampaign, IsNotFlownAgainFromAScenarioThatHasChanged) {
  asked.runs = 1;
  fly("mine");
  EXPECT_NO_THROW((void)repeat_run(campaign_in(folder / "mine", "test"), 0));
  EXPECT_THROW((void)repeat_run(campaign_in(folder / "mine", "test"), 1), text::Error) << "none of its runs";
  EXPECT_THROW((void)campaign_in(folder, "test"), text::Error) << "no campaign";
  std::ofstream{file.path(), std::ios::app} << "# changed\n";
  try {
    (void)campaign_in(folder / "mine", "test");
    FAIL() << "it was taken";
  } catch (const text::Error& error) {
    EXPECT_NE(std::string{error.what()}.find(
                  "this campaign cannot be flown again: scenario has different contents there and now (SHA-256 "),
              std::string::npos)
        << error.what();
  }
}

TEST_F(ACampaign, OfAnEarlierVersionWhoseRunsWereNotDrawnIndependentlyIsNotFlownAgain) {
  asked.runs = 1;
  fly("old");
  std::string words = content(folder / "old" / "campaign.json");
  words.replace(words.find("independent"), std::string_view{"independent"}.size(), "latin_hypercube");
  std::ofstream{folder / "old" / "campaign.json"} << words;
  try {
    (void)campaign_in(folder / "old", "test");
    FAIL() << "it was taken";
  } catch (const text::Error& error) {
    EXPECT_NE(std::string{error.what()}.find("sampling = \"latin_hypercube\"; allowed: independent"), std::string::npos)
        << error.what();
  }
}

TEST_F(ACampaign, SaysThatItFlewAgainWhatWasDamaged) {
  asked.runs = 2;
  const auto fly_whole = [&] { return fly_campaign(asked, folder / "whole", "test", 2, look_away); };
  const auto before = fly_whole();
  EXPECT_EQ(before.remark, "");
  EXPECT_EQ(fly_whole().remark, "");
  const fs::path whole_runs = folder / "whole" / "runs.csv.gz";
  const std::string bytes = content(whole_runs);
  fs::resize_file(whole_runs, bytes.size() - 9);
  const auto again = fly_whole();
  EXPECT_NE(said_of(whole_runs, again.remark).find("damaged"), std::string::npos) << again.remark;
  EXPECT_EQ(again.runs, before.runs);
  EXPECT_EQ(content(whole_runs), bytes);
}

TEST_F(ACampaign, NamesARowThatWasEditedAndFliesItsRunsAgain) {
  asked.runs = 2;
  const auto fly_whole = [&] { return fly_campaign(asked, folder / "whole", "test", 2, look_away); };
  const auto before = fly_whole();
  const fs::path rows = folder / "whole" / "runs.csv.gz";
  const std::string bytes = content(rows);
  const std::string text = text::gunzip(bytes).value();
  ASSERT_NE(before.runs[0].outcome, "no_control");
  const std::string row = csv_row(before.runs[1]);
  std::string better = row;  // an outcome that there is
  better.replace(better.find(before.runs[1].outcome), before.runs[1].outcome.size(), "no_control");
  std::string other_note = row;
  other_note.insert(other_note.rfind(','), "x");
  std::string other_check = row;
  other_check[other_check.size() - 2] = other_check[other_check.size() - 2] == '0' ? '1' : '0';
  for (const std::string& edited : {better, other_note, other_check}) {
    std::string changed = text;
    changed.replace(changed.find(row), row.size(), edited);
    std::ofstream{rows, std::ios::binary} << text::gzip(changed);
    const auto again = fly_whole();
    EXPECT_EQ(figures(said_of(rows, again.remark)), std::vector<std::string>{"1"}) << "the run of the row";
    EXPECT_EQ(again.runs, before.runs);
    EXPECT_EQ(content(rows), bytes);
  }
}

TEST_F(ACampaign, FliesAgainTheRowsOfAnEarlierVersionThatCarryNoCheckAndSaysSo) {
  asked.runs = 2;
  const auto runs = fly("whole");
  const fs::path rows = folder / "whole" / "runs.csv.gz";
  const std::string bytes = content(rows);
  std::string text = text::gunzip(bytes).value();
  text.erase(text.find(",row_check"), 10);
  std::ofstream{rows, std::ios::binary} << text::gzip(text);
  const auto again = fly_campaign(asked, folder / "whole", "test", 2, look_away);
  EXPECT_NE(said_of(rows, again.remark).find("earlier version"), std::string::npos) << again.remark;
  EXPECT_EQ(content(rows), bytes);
}

TEST_F(ACampaign, FliesAgainRowsWithAnOutcomeThatIsNone) {
  asked.runs = 2;
  const auto runs = fly("whole");
  const fs::path rows = folder / "whole" / "runs.csv.gz";
  std::string text = text::gunzip(content(rows)).value();
  text.replace(text.find(runs[0].outcome), runs[0].outcome.size(), "foo");
  std::ofstream{rows, std::ios::binary} << text::gzip(text);
  EXPECT_EQ(fly("whole"), runs);
}

TEST_F(ACampaign, RefusesAChangeOfWhatIsDrawnInItsPlace) {
  asked.runs = 1;
  asked.changes = {{"aerodynamics", "torque_m", "8"}};
  EXPECT_EQ(fly("about_another_middle").size(), 1U) << "the file's value is the mean";
  std::ofstream{file.path(), std::ios::app}
      << "[[spread]]\nfield = \"body.mass_kg\"\nlaw = \"uniform\"\nlow = 3.9\nhigh = 4.1\n";
  asked.changes = {{"body", "mass_kg", "4.5"}};
  EXPECT_NE(refusal("drawn").find("body.mass_kg = 4.5 changes nothing: "), std::string::npos) << refusal("drawn");
}

TEST_F(ACampaign, OfAnotherVersionIsNotFlownAgain) {
  asked.runs = 1;
  fly("mine");
  try {
    (void)campaign_in(folder / "mine", "another");
    FAIL() << "it was taken";
  } catch (const text::Error& error) {
    EXPECT_NE(std::string{error.what()}.find("version is test there and another now"), std::string::npos)
        << error.what();
  }
}

TEST_F(ACampaign, DoesNotMixWithAnotherInOneFolder) {
  asked.runs = 1;
  fly("mixed");
  asked.seed = 6;
  EXPECT_NE(refusal("mixed").find("mixed: holds another campaign: seed is 5 there and 6 here"), std::string::npos)
      << refusal("mixed");
  asked.seed = 5;
  asked.changes.push_back(input::parse_override("body.mass_kg=4"));
  EXPECT_NE(refusal("mixed").find("changes is none there and body.mass_kg=4 here"), std::string::npos)
      << refusal("mixed");
}

TEST_F(ACampaign, OfNoRunsOrWithoutASpreadIsRefused) {
  asked.runs = 0;
  EXPECT_EQ(refusal("none"), "0 runs; allowed: 1 or more");
  asked.runs = 1;
  asked.scenario = "tasha3_launch1";
  EXPECT_NE(refusal("none").find("has no [[spread]] table"), std::string::npos) << refusal("none");
}

class ARefusedDraw : public ACampaign {
 protected:
  ARefusedDraw() : ACampaign{"[[spread]]\nfield = \"timing.arm_time_s\"\nlaw = \"uniform\"\nlow = 11\nhigh = 12\n"} {}
};

TEST_F(ARefusedDraw, OfAValueThatAnotherDoesNotAllowIsARunThatSaysSo) {
  asked.runs = 1;
  const auto runs = fly("refused");
  EXPECT_EQ(runs[0].outcome, "refused");
  EXPECT_NE(runs[0].note.find("must be earlier than pad_time_s = 10"), std::string::npos) << runs[0].note;
  EXPECT_FALSE(runs[0].figures[0]);
  EXPECT_EQ(runs, fly("refused")) << "read back";
}

}  // namespace
}  // namespace fantail::campaign
