// SPDX-License-Identifier: MIT
#include <fstream>

#include <gmock/gmock.h>

#include "input/file_checks.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "scratch_file.hpp"
#include "test.hpp"

namespace fantail::input {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string content(Shipped kind, const std::string& name) {
  std::ifstream file{find_input(kind, name)};
  return {std::istreambuf_iterator<char>{file}, {}};
}

// The shipped text with one piece of it replaced.
std::string with(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return at == std::string::npos ? text : text.replace(at, old.size(), now);
}

std::vector<std::string> vehicle_warnings(const std::string& vehicle_text) {
  const ScratchFile vehicle{vehicle_text, "mine.toml"};
  const std::filesystem::path scenario = vehicle.path().parent_path() / "run.toml";
  std::ofstream{scenario} << "vehicle = \"mine.toml\"\nplan = \"tasha3_launch2\"\n";
  return load_scenario(scenario.string(), {}).vehicle.warnings;
}

TEST(Copied, AVehicleThatKeepsAnothersNameIsAskedAbout) {
  EXPECT_THAT(vehicle_warnings(content(Shipped::vehicle, "tasha3_launch2")),
              ElementsAre(AllOf(HasSubstr("mine.toml: body.name"), HasSubstr("shipped vehicle tasha3_launch2"),
                                HasSubstr("is it true of this rocket?"))));
}

TEST(Copied, AVehicleThatKeepsAnothersAssumptionsIsAskedAbout) {
  const sim::Vehicle shipped = load_scenario("tasha3_launch2", {}).vehicle;
  EXPECT_THAT(vehicle_warnings(
                  with(content(Shipped::vehicle, "tasha3_launch2"), "\"" + shipped.name + "\"", "\"My own rocket\"")),
              ElementsAre(AllOf(HasSubstr("body.assumed"),
                                HasSubstr("is an assumption of the shipped vehicle tasha3_launch2;"))));
}

TEST(Copied, AVehicleThatKeepsAnothersRollModelIsAskedAbout) {
  const std::string own =
      "[body]\nname = \"Mine\"\nmass_kg = 4\ndrag_area_m2 = 0.005\nroll_inertia_kg_m2 = 0.004\n"
      "[aerodynamics]\nreference_area_m2 = 5e-5\ndamping_m2 = 23\ntorque_m = 9\n[motor]\nfile = \"i150_canonical\"\n";
  EXPECT_THAT(vehicle_warnings(own),
              ElementsAre(AllOf(HasSubstr("aerodynamics.damping_m2 and torque_m are those of the shipped vehicle"),
                                HasSubstr("; were they found for this rocket?"))));
}

TEST(Copied, AVehicleOfItsOwnIsNotAskedAbout) {
  const std::string own =
      "[body]\nname = \"Mine\"\nassumed = [\"Drag: guessed.\"]\nmass_kg = 4\ndrag_area_m2 = 0.005\n"
      "roll_inertia_kg_m2 = 0.004\n[aerodynamics]\nreference_area_m2 = 5e-5\ndamping_m2 = 19\ntorque_m = 9\n"
      "[motor]\nfile = \"i150_canonical\"\n";
  EXPECT_THAT(vehicle_warnings(own), IsEmpty());
}

TEST(Copied, ASharedTunnelResultBesideAnotherVehicleIsAskedAbout) {
  const ScratchFile vehicle{content(Shipped::vehicle, "tasha3_launch2"), "mine.toml"};
  std::ofstream{vehicle.path().parent_path() / "run.toml"}
      << "vehicle = \"mine.toml\"\nplan = \"tasha3_launch2\"\ntunnel_result = \"tasha3_table2\"\n";
  EXPECT_THAT(load_scenario((vehicle.path().parent_path() / "run.toml").string(), {}).warnings,
              ElementsAre(AllOf(HasSubstr("tunnel_result \"tasha3_table2\""), HasSubstr("was this vehicle measured"))));
}

TEST(Copied, AScenarioThatKeepsAnothersAssumptionsIsAskedAbout) {
  const sim::Scenario shipped = load_scenario("tunnel_steps", {});
  const ScratchFile copy{content(Shipped::scenario, "tunnel_steps"), "run.toml"};
  EXPECT_THAT(load_scenario(copy.path().string(), {}).warnings,
              ElementsAre(AllOf(HasSubstr(shipped.assumed.front()), HasSubstr("is it true of this run?"))));
}

TEST(Copied, NoShippedScenarioIsAskedAbout) {
  for (const std::string& name : shipped_names(Shipped::scenario)) {
    const sim::Scenario scenario = load_scenario(name, {});
    EXPECT_THAT(scenario.warnings, IsEmpty()) << name;
    EXPECT_THAT(scenario.vehicle.warnings, IsEmpty()) << name;
  }
}

}  // namespace
}  // namespace fantail::input
