// SPDX-License-Identifier: MIT
#include <cctype>
#include <filesystem>
#include <fstream>

#include "system/folder.hpp"
#include "system/process.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

using Words = std::vector<std::string>;

class Help : public testing::TestWithParam<Words> {};

TEST_P(Help, ShowsThreeExamplesOfItsOwn) {
  Words words = GetParam();
  words.emplace_back("--help");
  const Outcome outcome = fantail(words);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const std::size_t examples = outcome.out.find("Examples:\n");
  ASSERT_NE(examples, std::string::npos) << outcome.out;
  std::string example = "\n  fantail ";
  for (const std::string& word : GetParam()) {
    example += word + ' ';
  }
  int count = 0;
  for (std::size_t at = examples; (at = outcome.out.find(example, at)) != std::string::npos; ++at) {
    ++count;
  }
  EXPECT_GE(count, 3) << outcome.out;
}

INSTANTIATE_TEST_SUITE_P(EachVerb, Help,
                         testing::Values(Words{}, Words{"fly"}, Words{"identify"}, Words{"paper"}, Words{"predict"},
                                         Words{"campaign"}, Words{"campaign", "faults"}, Words{"campaign", "hardover"},
                                         Words{"campaign", "detection"}, Words{"campaign", "rare"}, Words{"compare"},
                                         Words{"plan"}, Words{"plan", "check"}, Words{"plan", "show"},
                                         Words{"plan", "compile"}, Words{"tunnel"}, Words{"tunnel", "flow"},
                                         Words{"tunnel", "swirl"}, Words{"tunnel", "steps"},
                                         Words{"tunnel", "stability"}, Words{"airframe"}, Words{"new"},
                                         Words{"listen"}),
                         [](const auto& one) {
                           std::string name = "fantail";
                           for (const std::string& word : one.param) {
                             name += "_" + word;
                           }
                           return name;
                         });

TEST(Version, IsOneLine) {
  const Outcome outcome = fantail({"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.out.starts_with("fantail ")) << outcome.out;
  EXPECT_TRUE(std::isdigit(static_cast<unsigned char>(outcome.out[8])));
  EXPECT_EQ(outcome.out.find('\n'), outcome.out.size() - 1);
}

TEST(CommandLine, WithoutAVerbTheVerbsStandOnStandardErrorInGroupsWithExitCode64) {
  const Outcome outcome = fantail({});
  EXPECT_EQ(outcome.exit_code, 64);
  EXPECT_EQ(outcome.out, "");
  std::size_t at = 0;
  for (const char* const part :
       {"Usage: fantail VERB", "\nYour rocket:\n", "\n  new ", "\nFlights:\n", "\n  fly ",
        "\nLogs and the roll model:\n", "\n  identify ", "\nA rocket on the bench:\n", "\n  watch "}) {
    const std::size_t found = outcome.err.find(part, at);
    ASSERT_NE(found, std::string::npos) << part << outcome.err;
    at = found;
  }
}

struct Wrong {
  const char* name;
  Words words;
  const char* said;  ///< must be part of the message
};

class WrongUsage : public testing::TestWithParam<Wrong> {};

TEST_P(WrongUsage, IsSaidOnStandardErrorWithExitCode64) {
  const Folder folder;
  const Outcome outcome = fantail(GetParam().words, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 64);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.err.starts_with("fantail: ")) << outcome.err;
  EXPECT_NE(outcome.err.find(GetParam().said), std::string::npos) << outcome.err;
  EXPECT_TRUE(folder.listing().empty());
}

INSTANTIATE_TEST_SUITE_P(
    CommandLine, WrongUsage,
    testing::Values(Wrong{"UnknownVerb", {"frobnicate"}, "frobnicate"}, Wrong{"NearlyAVerb", {"flY"}, "flY"},
                    Wrong{"UnknownOption", {"fly", "--bogus"}, "--bogus"},
                    Wrong{"OptionOfAnotherVerb", {"plan", "show", "tasha3_launch1", "--seed", "1"}, "--seed"},
                    Wrong{"OptionWithoutAVerb", {"--json"}, "--json"},
                    Wrong{"OutWithoutAValue", {"fly", "--out"}, "--out"},
                    Wrong{"OutWithAnEmptyValue", {"fly", "--out", ""}, "--out"},
                    Wrong{"SeedWithoutAValue", {"fly", "--seed"}, "--seed"},
                    Wrong{"SeedThatIsAFraction", {"fly", "--seed", "1.5"}, "--seed"},
                    Wrong{"SeedThatIsNegative", {"fly", "--seed", "-1"}, "--seed"},
                    Wrong{"SeedTooLargeForItsType", {"fly", "--seed", "18446744073709551616"}, "--seed"},
                    Wrong{"SeedThatIsAWord", {"fly", "--seed", "x"}, "--seed"},
                    Wrong{"SeedThatIsEmpty", {"fly", "--seed", ""}, "--seed"},
                    Wrong{"SetWithoutAValue", {"fly", "--set"}, "--set"},
                    Wrong{"TwoScenarios", {"fly", "tasha3_launch1", "tasha3_launch2"}, "tasha3_launch2"},
                    Wrong{"PlanWithoutAnAction", {"plan"}, "check, show, compile"},
                    Wrong{"PlanWithAnUnknownAction", {"plan", "frobnicate", "tasha3_launch1"}, "frobnicate"},
                    Wrong{"PlanCheckWithoutAPlan", {"plan", "check"}, "PLAN"}),
    [](const auto& one) { return one.param.name; });

TEST(Seed, TheLargestIsTaken) {
  const Folder folder;
  const Outcome outcome =
      fantail({"fly", "--seed", "18446744073709551615", "--json"}, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\"seed\": 18446744073709551615"), std::string::npos);
  EXPECT_NE(outcome.out.find("\"seed_text\": \"18446744073709551615\""), std::string::npos);
}

TEST(CommandLine, ANumberThatIsNoneIsOutsideEveryRange) {
  for (const char* option : {"--servo-lag", "--servo-delay", "--swirl", "--phase-margin", "--held-percent"}) {
    const Outcome outcome = fantail({"predict", option, "nan"});
    EXPECT_EQ(outcome.exit_code, 64) << option;
    EXPECT_NE(outcome.err.find(std::string{option} + ": \"nan\": allowed: "), std::string::npos) << outcome.err;
  }
}

TEST(CommandLine, AnUnknownOptionLeadsToTheNearest) {
  const Outcome near = fantail({"fly", "--sed", "3"});
  EXPECT_EQ(near.exit_code, 64);
  EXPECT_NE(near.err.find("unknown option --sed; did you mean --seed?"), std::string::npos) << near.err;
  const Outcome far = fantail({"fly", "--frobnicate"});
  EXPECT_NE(far.err.find("unknown option --frobnicate; allowed: "), std::string::npos) << far.err;
}

TEST(CommandLine, AnOptionThatHasLeftSaysWhatToDoInstead) {
  for (const Words& words : {Words{"fly", "--card"}, Words{"report", "flown.ftl", "--card"}}) {
    const Outcome outcome = fantail(words);
    EXPECT_EQ(outcome.exit_code, 64);
    EXPECT_NE(outcome.err.find("--card draws no card.png any more: take a screenshot of report.html"),
              std::string::npos)
        << outcome.err;
  }
}

TEST(CommandLine, NoWordBehindABareDoubleDashIsAnOptionOrAVerb) {
  const Outcome file = fantail({"report", "--", "--odd.csv"});
  EXPECT_NE(file.err.find("--odd.csv: no such file"), std::string::npos) << file.err;
  const Outcome surplus = fantail({"fly", "--", "--odd", "--sed"});
  EXPECT_EQ(surplus.exit_code, 64);
  EXPECT_NE(surplus.err.find("\"--sed\" is one word too many for fly"), std::string::npos) << surplus.err;
  const Outcome verb = fantail({"plan", "--", "check"});
  EXPECT_EQ(verb.exit_code, 64);
  EXPECT_NE(verb.err.find("\"check\" is not a verb after a bare --"), std::string::npos) << verb.err;
}

TEST(CommandLine, AFolderIsNoScenario) {
  const Folder folder;
  std::filesystem::create_directory(folder.path() / "tasha3_launch1_mine");
  const Outcome outcome = fantail({"fly", "tasha3_launch1_mine"}, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 66);
  EXPECT_NE(outcome.err.find("tasha3_launch1_mine: a folder; allowed: a scenario file or a shipped name"),
            std::string::npos)
      << outcome.err;
}

TEST(Copy, IsFlownByItsNameWithoutExtensionAndItsQuestionIsOnStandardErrorAndInTheNotes) {
  const Folder folder;
  std::filesystem::copy_file(std::filesystem::path{FANTAIL_TEST_SOURCE} / "sim/vehicles/tasha3_launch2.toml",
                             folder.path() / "mine.toml");
  std::ofstream{folder.path() / "my_scenario.toml"} << "vehicle = \"mine.toml\"\nplan = \"tasha3_launch2\"\n";
  const Outcome outcome = fantail({"fly", "my_scenario"}, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string question = "is that of the shipped vehicle tasha3_launch2; is it true of this rocket?";
  EXPECT_NE(outcome.err.find("fantail: warning: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(question), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find(question), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace fantail::test
