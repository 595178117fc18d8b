// SPDX-License-Identifier: MIT
#include "input/number_field.hpp"

#include <filesystem>
#include <fstream>

#include "core/flight_plan_fields.hpp"
#include "input/file_text.hpp"
#include "input/plan_file.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "protocol/plan_block.hpp"
#include "scratch_file.hpp"
#include "test.hpp"
#include "text/error.hpp"

namespace fantail::input {
namespace {

std::string refusal(const std::string& name) {
  try {
    (void)number_field(ScenarioFiles::load("tasha3_launch2"), name);
  } catch (const text::Error& error) {
    return error.what();
  }
  return "it was found";
}

TEST(NumberField, IsFoundInScenarioVehicleAndPlanWithUnitRangeAndValue) {
  const ScenarioFiles files = ScenarioFiles::load("tasha3_launch2");
  const NumberField inertia = number_field(files, "body.roll_inertia_kg_m2");
  EXPECT_EQ(inertia.values, std::vector{0.00393});
  EXPECT_EQ(inertia.unit, "kg m2");
  const NumberField tilt = number_field(files, "launch_guide.tilt_deg");
  EXPECT_EQ(tilt.unit, "deg");
  EXPECT_EQ(tilt.range.maximum, 15.0);
  const NumberField gain = number_field(files, "controller.proportional_gain");
  EXPECT_EQ(gain.values, std::vector{0.5}) << "of the plan";
  EXPECT_EQ(gain.name(), "controller.proportional_gain");
}

TEST(NumberField, HasTheUsualValueWhereItsFileIsSilent) {
  const ScenarioFiles files = ScenarioFiles::load("tasha3_launch2");
  EXPECT_EQ(number_field(files, "timing.pad_time_s").values, std::vector{10.0});
  EXPECT_EQ(number_field(files, "recording.threshold_g").values, std::vector{2.0});
  const NumberField trim = number_field(files, "canard_mounting.trim_deg");
  EXPECT_EQ(trim.values, std::vector(4, 0.0)) << "one a canard";
  EXPECT_EQ(trim.with({1, 2, 3, 4}).value, "[1, 2, 3, 4]");
}

TEST(NumberField, KeepsAListAListAndEveryDigit) {
  ScenarioFiles files = ScenarioFiles::load("tasha3_launch2");
  const NumberField offset = number_field(files, "disturbance.angles_deg");
  EXPECT_EQ(offset.values, std::vector{-4.9});
  EXPECT_EQ(offset.with({-1.0 / 3.0}).value, "[-0.3333333333333333]");
  files.apply(offset.with({-2.0}));
  EXPECT_NEAR(files.read().disturbance.front().angle_rad, -0.034906585, 1e-9);
  const NumberField inertia = number_field(files, "body.roll_inertia_kg_m2");
  for (const double value : {0.1 + 0.2, 0.00393, 1e-5 / 3.0}) {
    files.apply(inertia.with({value}));
    EXPECT_EQ(files.read().vehicle.roll_plant.inertia_kg_m2, value);
  }
}

TEST(NumberField, IsRefusedWithWhatIsWrongWithItsName) {
  EXPECT_EQ(refusal("mass_kg"), "\"mass_kg\" is not a field; allowed: section.key, as in body.mass_kg");
  EXPECT_EQ(refusal("bodi.mass_kg"), "unknown section bodi; did you mean body?");
  EXPECT_EQ(refusal("body.mass"), "unknown key body.mass; did you mean body.mass_kg?");
  EXPECT_EQ(refusal("flight.motion"),
            "flight.motion is not a number that can be spread; allowed: a number that need not be whole");
  EXPECT_NE(refusal("airframe.nozzle_position_m").find("and there is no default"), std::string::npos)
      << refusal("airframe.nozzle_position_m");
}

TEST(ScenarioFiles, AreReadAgainWithOtherValuesAndSayWhatAFreshReadingSays) {
  ScenarioFiles files = ScenarioFiles::load("tasha3_launch2");
  const double usual = files.read().vehicle.mass_kg;
  const Override heavier = parse_override("body.mass_kg=4.5");
  files.apply(heavier);
  EXPECT_EQ(files.read().vehicle.mass_kg, load_scenario("tasha3_launch2", std::vector{heavier}).vehicle.mass_kg);
  files.apply(parse_override("body.mass_kg=3.99"));
  EXPECT_EQ(files.read().vehicle.mass_kg, usual);
}

core::FlightPlan shipped(const std::string& name) { return read_plan(Document::load(find_input(Shipped::plan, name))); }

core::FlightPlan changed(const core::FlightPlan& plan, const std::string& text) {
  return changed_plan(plan, std::array{parse_override(text)});
}

TEST(ChangedPlan, EveryOtherValueKeepsItsBits) {
  for (const std::string& name : shipped_names(Shipped::plan)) {
    const core::FlightPlan plan = shipped(name);
    core::FlightPlan expected = plan;
    expected.controller.canard_limit = core::Angle::from_degrees(3.5F);
    EXPECT_EQ(protocol::plan_crc(changed(plan, "controller.canard_limit_deg=3.5")), protocol::plan_crc(expected))
        << name;
    EXPECT_EQ(protocol::plan_crc(changed_plan(plan, {})), protocol::plan_crc(plan)) << name;
  }
}

TEST(ChangedPlan, RulesThatSpanSeveralValuesSeeThoseOfThePlan) {
  const core::FlightPlan plan = shipped("tunnel_steps");
  // Steps are allowed because the plan has some; the default plan has none.
  EXPECT_NO_THROW((void)changed(plan, "controller.canard_limit_deg=4"));
}

TEST(ChangedPlan, WhatAFileMayNotSayIsRefused) {
  const core::FlightPlan plan = core::default_plan();
  for (const char* text : {"controller.canard_limit_deg=90", "controller.no_such_key=1", "nowhere.key=1",
                           "controller.canard_limit_deg=wide"}) {
    EXPECT_THROW((void)changed(plan, text), text::Error) << text;
  }
}

TEST(FileText, IsAllThatStandsInTheFile) {
  const std::string content{"a = 1\r\n\0\xff\n", 10};
  EXPECT_EQ(file_text(ScratchFile{content}.path()), content);
  EXPECT_EQ(file_text(ScratchFile{""}.path()), "");
}

TEST(FileText, IsNoneOfWhatIsNoFile) {
  EXPECT_EQ(file_text("/nowhere/a.toml"), std::nullopt);
  EXPECT_THROW((void)file_text("/"), text::Error) << "a folder";
}

// What a person may name, and what is said of the rest.

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
  EXPECT_NE(refused.message.find("vehicle is missing (is vehicel a misspelling of it?)"), std::string::npos)
      << refused.message;
}

}  // namespace

}  // namespace fantail::input
