// SPDX-License-Identifier: MIT
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"

namespace fantail::test {
namespace {

TEST(Tune, WritesAPlanThatIsCheckedAndFlies) {
  const Folder folder;
  const std::vector<std::string> command{"tune", "tasha3_launch2", "--flights", "4"};
  const Outcome outcome = fantail(command, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("The new plan is better"), std::string::npos) << outcome.out;
  EXPECT_NE(content(folder.path() / "out/tune/tasha3_launch2+flights=4/tune.html").find("Proposed"), std::string::npos);
  const std::string plan = folder / "tasha3_launch2_tuned.toml";
  EXPECT_TRUE(content(plan).starts_with("# Made by fantail tune tasha3_launch2 --flights=4 (Fantail "));
  const Outcome check = fantail({"plan", "check", plan, "--scenario", "tasha3_launch2"});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_EQ(check.out.find("warning"), std::string::npos) << check.out;

  const std::string scenario =
      folder.write("s.toml", "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2_tuned.toml\"\n");
  EXPECT_EQ(fantail({"fly", scenario, "--out", folder / "flown"}).exit_code, 0);

  const Outcome again = fantail(command, {.working_folder = folder.path()});
  EXPECT_EQ(again.exit_code, 64);
  EXPECT_NE(again.err.find("is there already"), std::string::npos) << again.err;
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
