// SPDX-License-Identifier: MIT
#include <filesystem>

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

TEST(Tune, WritesAPlanThatIsCheckedAndFliesWhereItSays) {
  const Folder folder;
  std::string scenario = content(std::filesystem::path{FANTAIL_TEST_SOURCE} / "sim/scenarios/tasha3_launch2.toml");
  folder.write("own/s.toml", scenario);
  const std::vector<std::string> command{"tune", "own/s.toml", "--flights", "4"};
  const Outcome outcome = fantail(command, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("The new plan is better"), std::string::npos) << outcome.out;
  EXPECT_NE(content(folder.path() / "out/tune/s+flights=4/tune.html").find("Proposed"), std::string::npos);
  const std::string plan = folder / "tasha3_launch2_tuned.toml";
  EXPECT_TRUE(content(plan).starts_with("# Made by fantail tune own/s.toml --flights 4 (Fantail "));
  const Outcome check = fantail({"plan", "check", plan, "--scenario", "tasha3_launch2"});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  const std::size_t tilt = check.out.find("warning: run.tilt_limit_deg = 60 from the vertical");
  EXPECT_NE(tilt, std::string::npos) << "of the plan that it was made from: " << check.out;
  EXPECT_EQ(check.out.find("warning"), tilt) << check.out;
  EXPECT_EQ(check.out.rfind("warning"), tilt) << check.out;

  const Outcome again = fantail(command, {.working_folder = folder.path()});
  EXPECT_EQ(again.exit_code, 64);
  EXPECT_NE(again.err.find("already exists"), std::string::npos) << again.err;

  const std::string named = "plan = \"../tasha3_launch2_tuned.toml\"";
  EXPECT_NE(outcome.out.find("name it in own/s.toml: " + named + "\n"), std::string::npos) << outcome.out;
  const std::string old = "plan = \"tasha3_launch2\"";
  ASSERT_NE(scenario.find(old), std::string::npos);
  folder.write("own/s.toml", scenario.replace(scenario.find(old), old.size(), named));
  EXPECT_EQ(fantail({"fly", folder / "own/s.toml", "--out", folder / "flown"}).exit_code, 0);
  EXPECT_NE(content(folder.path() / "flown/summary.json").find("tasha3_launch2_tuned"), std::string::npos);
}

TEST(Tune, OfAnOffsetBeyondTheLimitWritesNoPlan) {
  const Folder folder;
  const Outcome outcome = fantail({"tune", "tasha3_launch1", "--json"}, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json::Value said = json::parse(outcome.out);
  EXPECT_EQ(said["proposed"], false);
  EXPECT_NE(said["why_none"].text().find("beyond the 6 degree canard limit"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "tasha3_launch1_tuned.toml"));
}

}  // namespace
}  // namespace fantail::test
