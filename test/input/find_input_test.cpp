// SPDX-License-Identifier: MIT
// What a person may name, and what is said of the rest.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "input/plan_file.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "scratch_file.hpp"

namespace fantail::input {
namespace {

const std::string scenario_text = "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n";

std::string refusal(Shipped kind, const std::string& name) {
  const Complaint refused = complaint([&] { (void)find_input(kind, name); });
  EXPECT_EQ(refused.fault, text::ErrorKind::no_such_input);
  return refused.message;
}

TEST(FindInput, ResultsOfWhatFantailNewMadeAreCalledAsItsFolder) {
  EXPECT_EQ(name_of_file("hawk/scenario.toml"), "hawk");
  EXPECT_EQ(name_of_file("hawk/vehicle.toml"), "hawk");
  EXPECT_EQ(name_of_file("hawk/windy.toml"), "windy");
}

TEST(FindInput, TheExtensionMayBeLeftOut) {
  const ScratchFile file{scenario_text, "my_scenario.toml"};
  EXPECT_EQ(find_input(Shipped::scenario, (file.path().parent_path() / "my_scenario").string()), file.path());
}

TEST(FindInput, AFolderIsCalledOneWithTheFilesInIt) {
  const ScratchFile file{scenario_text, "my_scenario.toml"};
  const std::string folder = file.path().parent_path().string();
  EXPECT_EQ(refusal(Shipped::scenario, folder),
            folder + ": a folder; allowed: a scenario file or a shipped name; files in it: my_scenario.toml");
}

TEST(FindInput, AFolderOfResultsLeadsToItsScenario) {
  const ScratchFile file{scenario_text};
  const std::filesystem::path folder = file.path().parent_path() / "tasha3_launch1";
  std::filesystem::create_directory(folder);
  for (const std::string& name : {folder.string(), folder.string() + "/"}) {
    EXPECT_TRUE(refusal(Shipped::scenario, name).ends_with("did you mean tasha3_launch1?")) << name;
  }
}

TEST(FindInput, AMissingFileLeadsToTheNearestBesideIt) {
  const ScratchFile file{scenario_text, "my_scenario.toml"};
  const std::string wrong = (file.path().parent_path() / "my_scenaro.toml").string();
  EXPECT_EQ(refusal(Shipped::scenario, wrong), wrong + ": no such file; did you mean " + file.path().string() + "?");
}

TEST(FileKind, AVehicleIsNoScenario) {
  const std::string vehicle = find_input(Shipped::vehicle, "tasha3_launch2").string();
  const Complaint refused = complaint([&] { (void)load_scenario(vehicle, {}); });
  EXPECT_EQ(refused.fault, text::ErrorKind::bad_configuration);
  EXPECT_TRUE(refused.message.ends_with(" belongs to a vehicle; allowed here: a scenario")) << refused.message;
}

TEST(FileKind, AScenarioIsNoVehicleAndNoPlan) {
  const ScratchFile file{scenario_text, "plan.toml"};
  EXPECT_EQ(complaint([&] { (void)read_vehicle(Document::load(file.path().string())); }).message,
            "plan.toml:2: plan belongs to a scenario; allowed here: a vehicle");
  EXPECT_EQ(complaint([&] { (void)read_plan(Document::load(file.path().string())); }).message,
            "plan.toml:2: plan belongs to a scenario; allowed here: a flight plan");
}

TEST(MissingKey, NamesTheOneThatLooksLikeIt) {
  const ScratchFile file{"vehicel = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n", "plan.toml"};
  const Complaint refused = complaint([&] { (void)load_scenario(file.path().string(), {}); });
  EXPECT_NE(refused.message.find("vehicle is missing (is vehicel meant to be it?)"), std::string::npos)
      << refused.message;
}

}  // namespace
}  // namespace fantail::input
