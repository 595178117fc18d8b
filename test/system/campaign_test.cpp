// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>

#include <fmt/core.h>
#include <sys/resource.h>

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "system/refusal.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

namespace fs = std::filesystem;

json::Value summary(const fs::path& folder) { return json::parse(content(folder / "summary.json")); }

TEST(Campaign, WritesItsRunsSummaryPageAndTheReportsOfItsWorstRunsAndIsReadBackTheNextTime) {
  const Folder folder;
  const Words words{"campaign", "tasha3_launch2", "--runs", "70", "--set", "controller.canard_limit_deg=5"};
  const Outcome outcome = fantail(words, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const fs::path written = folder.path() / "out/campaign/tasha3_launch2+controller.canard_limit_deg=5+runs=70";
  const json::Value said = summary(written);
  EXPECT_EQ(said["runs"], 70);
  EXPECT_EQ(said["share"]["of"], 70);
  EXPECT_GT(said["share"]["count"].number(), 0.0);
  EXPECT_LT(said["share"]["count"].number(), 70.0) << "the limit is about the offset";
  EXPECT_EQ(said["influences"]["of"].size(), 11U);
  for (const json::Value& worst : said["worst_runs"]) {
    EXPECT_TRUE(fs::exists(written / worst["folder"].text() / "report.html")) << worst;
  }
  EXPECT_NE(content(written / "campaign.html").find("run_"), std::string::npos);
  const std::string bytes = content(written / "runs.csv.gz");

  const Outcome again = fantail({"campaign", "tasha3_launch2", "--runs", "70", "--set", "controller.canard_limit_deg=5",
                                 "--share", "apogee_m>=400", "--json"},
                                {.working_folder = folder.path()});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(json::parse(again.out), summary(written));
  EXPECT_EQ(summary(written)["question"], "apogee_m>=400");
  EXPECT_EQ(content(written / "runs.csv.gz"), bytes);
}

TEST(Campaign, AnyRunIsFlownAgainWithItsReport) {
  const Folder folder;
  ASSERT_EQ(fantail({"campaign", "--runs", "6", "--out", folder / "all"}).exit_code, 0);
  const json::Value worst = summary(folder / "all")["worst_runs"][0];
  const std::string number = std::to_string(worst["run"].count());
  const Outcome outcome =
      fantail({"fly", "--campaign", folder / "all", "--run", number, "--out", folder / "again", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(content(folder / "again/flight.csv"), content(folder / ("all/run_" + number + "/flight.csv")));
  const json::Value flown = json::parse(outcome.out);
  EXPECT_EQ(flown["seed"], worst["seed"]);
  EXPECT_NE(outcome.out.find("Run " + number + " of a campaign of 6 with seed 1; drawn for it: "), std::string::npos);
}

TEST(Campaign, InShardsIsTheSameBytesAsInOne) {
  const Folder folder;
  for (const char* number : {"1", "2"}) {
    const Outcome shard =
        fantail({"campaign", "--runs", "100", "--shard", std::string{number} + "/2", "--out", folder / number});
    EXPECT_EQ(shard.exit_code, 0) << shard.err;
    EXPECT_FALSE(fs::exists(fs::path{folder / number} / "summary.json"));
  }
  EXPECT_EQ(fantail({"campaign", "merge", folder / "1", "--out", folder / "merged"}).exit_code, 78);
  EXPECT_FALSE(fs::exists(folder / "merged"));
  const Outcome merged = fantail({"campaign", "merge", folder / "2", folder / "1", "--out", folder / "merged"});
  EXPECT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_NE(merged.out.find("--out " + (folder / "merged")), std::string::npos) << merged.out;
  for (const char* name : {"merged", "whole"}) {
    EXPECT_EQ(fantail({"campaign", "--runs", "100", "--sampling", "independent", "--out", folder / name}).exit_code, 0);
  }
  for (const char* file : {"runs.csv.gz", "campaign.json", "summary.json"}) {
    EXPECT_EQ(content(fs::path{folder / "merged"} / file), content(fs::path{folder / "whole"} / file)) << file;
  }
}

TEST(Campaign, SaysByItsExitCodeWhetherTheShareIsMetAndIsNotDecidedByTooFewRuns) {
  const Folder folder;
  const Outcome few = fantail({"campaign", "--runs", "3", "--at-least", "99", "--out", folder / "few"});
  EXPECT_EQ(few.exit_code, 1) << few.err;
  EXPECT_EQ(summary(folder / "few")["judgement"], "undecided");
  const Outcome met =
      fantail({"campaign", "--runs", "640", "--at-least", "80", "--until-decided", "--out", folder / "met"});
  EXPECT_EQ(met.exit_code, 0) << met.err << met.out;
  EXPECT_EQ(summary(folder / "met")["judgement"], "met");
  EXPECT_NE(met.out.find("Stopped after 64 of 640 runs, by the rule: Outcome held, decided at 80 %."),
            std::string::npos)
      << met.out;
}

TEST(Campaign, ThatFindsNoRoomOnTheDiskKeepsThePartsBefore) {
  const Folder folder;
  const Words words{"campaign", "--runs", "10", "--out", folder / "all"};
  const rlimit limit{700, 700};  // enough for identity.json, not for a part
  const Outcome outcome = fantail(words, {.prepare = [limit] { setrlimit(RLIMIT_FSIZE, &limit); }});
  EXPECT_EQ(outcome.exit_code, 74) << outcome.err;
  EXPECT_NE(outcome.err.find("00000000.part"), std::string::npos) << outcome.err;
  EXPECT_EQ(fantail(words).exit_code, 0) << "and goes on";
}

TEST(Campaign, OfDetectionsHasACommandForItsWorstEventThatSaysTheSameOfItsPlanAgain) {
  const Folder folder;
  const Outcome all = fantail({"campaign", "detection", "--plan", "tasha3_launch1", "--kind", "shaking", "--events",
                               "40", "--seed", "3", "--out", folder / "all"});
  const std::string page = content(folder / "all/detection.html");
  const std::size_t at = page.find("fantail campaign detection --kind shaking");
  ASSERT_NE(at, std::string::npos) << all.err;
  std::istringstream command{page.substr(at, page.find('<', at) - at)};
  Words words{std::istream_iterator<std::string>{command}, {}};
  words.erase(words.begin());
  words.insert(words.end(), {"--out", folder / "one"});
  const Outcome one = fantail(words);
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_NE(one.out.find("tasha3_launch1: "), std::string::npos) << one.out;
  EXPECT_EQ(one.out.find("tasha3_launch2: "), std::string::npos) << one.out;
  const json::Value said = json::parse(content(folder / "one/shaking_" + words[5] + ".json"));
  EXPECT_GT(said["what_happens"].size(), 3U);
  for (const json::Value& sentence : said["what_happens"]) {
    EXPECT_NE(page.find(sentence.text()), std::string::npos) << sentence;
  }
}

TEST(Campaign, OfWordsThatMakeNoSenseIsRefused) {
  const Refusal none{{}, {"campaign", "--runs", "0"}, 64, {"--runs", "allowed: 1 to "}};
  const Refusal question{
      {}, {"campaign", "--share", "held"}, 64, {"\"held\" is not a question; allowed: outcome=held"}};
  const Refusal undecided{{}, {"campaign", "--until-decided"}, 64, {"--until-decided", "--at-least"}};
  const Refusal shard{{}, {"campaign", "--shard", "3/2"}, 64, {"\"3/2\" is not a shard; allowed: NUMBER/OF"}};
  const Refusal shards{{}, {"campaign", "--runs", "10", "--shard", "1/2"}, 78, {"of at most 1"}};
  const Refusal certain{{}, {"campaign", "tasha3_launch1"}, 78, {"has no [[spread]] table"}};
  const Refusal early{
      {}, {"campaign", "--runs", "100", "--until-within", "5", "--shard", "1/2"}, 78, {"stop early only as a whole"}};
  const Refusal sobol{{}, {"campaign", "--sampling", "sobol"}, 64, {"\"sobol\"; allowed: independent", "were removed"}};
  const Refusal alone{{}, {"fly", "--run", "3"}, 64, {"--campaign"}};
  const Refusal nowhere{{}, {"fly", "--campaign", "nowhere", "--run", "3"}, 66, {"nowhere"}};
  const Refusal changed{{}, {"fly", "--campaign", ".", "--run", "3", "--seed", "3"}, 64, {"repeats a run unchanged"}};
  const Refusal outside{{{"wide.toml",
                          "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n[[spread]]\nfield = "
                          "\"servo.delay_s\"\nlaw = \"normal\"\nmean = 0.01\nstandard_deviation = 0.02\n"}},
                        {"campaign", "wide.toml"},
                        78,
                        {"wide.toml", "servo.delay_s", "allowed: 0 to 0.05", "outside = \"truncate\""}};
}

TEST(CampaignHardover, TakesChangesThatPlayAPartInSixDegreesOfFreedomAlone) {
  const Folder folder;
  const Outcome outcome = fantail({"campaign", "hardover", "--step", "9", "--set", "wind.speed_m_s=6", "--set",
                                   "wind.from_deg=180", "--set", "launch_guide.azimuth_deg=90", "--out", folder / "h"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("wind.from_deg=180, launch_guide.azimuth_deg=90"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("flight.motion"), std::string::npos) << "nobody has asked for that";
}

TEST(CampaignRare, FindsWhatIsRareAndItsFlightsAreThemselvesAgain) {
  const Folder folder;
  const Outcome outcome = fantail({"campaign", "rare", "--flights", "200", "--share", "apogee_m>=320", "--at-most",
                                   "1e-9", "--out", folder / "r", "--json"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json::Value said = json::parse(outcome.out);
  EXPECT_EQ(said["answer"], "no");
  EXPECT_GT(said["levels"].size(), 2U);
  EXPECT_LT(said["probability"].number(), 1e-2);
  EXPECT_LT(said["low_95"].number(), said["probability"].number());
  // The likeliest failure, from its seed and what was drawn.
  Words again{"fly",    "--json",
              "--out",  folder / "again",
              "--seed", fmt::format("{:.0f}", said["likeliest"][0]["seed"].number())};
  std::istringstream changes{said["likeliest"][0]["changes"].text()};
  for (std::string change; changes >> change;) {
    while (std::ranges::count(change, '[') > std::ranges::count(change, ']')) {  // of a list, which has spaces
      std::string rest;
      ASSERT_TRUE(changes >> rest);
      change += ' ' + rest;
    }
    again.insert(again.end(), {"--set", change});
  }
  const Outcome alone = fantail(again);
  EXPECT_EQ(alone.exit_code, 0) << alone.err;
  EXPECT_NEAR(json::parse(alone.out)["apogee_m"].number() - 320.0, said["likeliest"][0]["margin"].number(), 1e-4);
}

TEST(CampaignRare, RefusesWhatItCannotSearch) {
  Refusal({}, {"campaign", "rare", "--share", "outcome=cut_short"}, 64, {"no figure tells how far", "outcome=held"});
  Refusal({}, {"campaign", "rare", "--share", "nonsense"}, 64, {"nonsense"});
  Refusal({}, {"campaign", "rare", "--flights", "99"}, 64, {"--flights"});
  Refusal({}, {"campaign", "rare", "tunnel_steps"}, 78, {"no [[spread]] table"});
}

TEST(CampaignDetection, OneEventTakesNoOptionOfTheWholeCampaign) {
  for (const Words& option :
       {Words{"--at-most", "1"}, Words{"--false-at-most", "1"}, Words{"--events", "9"}, Words{"--launches", "9"}}) {
    Words words{"campaign", "detection", "--kind", "shaking", "--event", "277"};
    words.insert(words.end(), option.begin(), option.end());
    Refusal({}, words, 64, {option.front(), "--event"});
  }
}

TEST(CampaignDetection, BothWellShowsNoEventThatItLeavesOut) {
  Refusal({}, {"campaign", "detection", "--both-well", "--kind", "shaking", "--event", "277"}, 64,
          {"--both-well leaves out shaking 277: one accelerometer is bad in it"});
  const Folder folder;
  EXPECT_EQ(
      fantail({"campaign", "detection", "--both-well", "--kind", "shaking", "--event", "278", "--out", folder / "x"})
          .exit_code,
      0);
}

}  // namespace
}  // namespace fantail::test
