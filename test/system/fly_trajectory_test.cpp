// SPDX-License-Identifier: MIT
#include <cmath>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "system/refusal.hpp"

namespace fantail::test {
namespace {

/// 40 m/s2 for two seconds, then a throw.
std::string thrown(int last_row = 1200) {
  std::string text = "# Time (s),Altitude (m),Vertical velocity (m/s)\n";
  for (int i = 0; i <= last_row; ++i) {
    const double t = 0.01 * i;
    const double c = t - 2.0;
    text += t < 2.0 ? fmt::format("{:.2f},{:.4f},{:.4f}\n", t, 20.0 * t * t, 40.0 * t)
                    : fmt::format("{:.2f},{:.4f},{:.4f}\n", t, 80.0 + 80.0 * c - 5.0 * c * c, 80.0 - 10.0 * c);
  }
  return text;
}

TEST(FlyTrajectory, ReachesTheHeightOfTheFileAndSaysWhereThePathIsFrom) {
  const Folder folder;
  folder.write("other.csv", thrown());
  const Outcome outcome =
      fantail({"fly", "tasha3_launch2", "--trajectory", "other.csv"}, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("The path of this flight is that of other.csv (1201 rows to 12.00 s)"), std::string::npos)
      << outcome.out;
  const std::filesystem::path results = std::filesystem::path{folder / "out/tasha3_launch2+trajectory=other.csv"};
  const json::Value summary = json::parse(content(results / "summary.json"));
  EXPECT_NEAR(summary["apogee_m"].number(), 400.0, 0.1);  // 80 + 80^2 / 20
  EXPECT_NEAR(summary["max_speed_m_s"].number(), 80.0, 0.1);
  EXPECT_NEAR(summary["events"]["apogee_s"].number(), 10.0, 0.02);
  EXPECT_EQ(summary["changes"][0], "trajectory=other.csv");
  EXPECT_NE(content(results / "report.html").find("that of other.csv"), std::string::npos);
  EXPECT_NE(content(results / "report.html").find("The path"), std::string::npos);
  EXPECT_EQ(content(results / "trajectory.csv").find("time_s,across_m,height_m,across_m_s,up_m_s,tilt_deg\n"), 0U);
  EXPECT_EQ(summary["notes"][1].text().find("The next 5 sentences are of vehicle and scenario."), 0U)
      << summary["notes"];
}

TEST(FlyTrajectory, OneThatEndsInTheClimbIsJudgedAsFarAsItReachesAlsoWhenItIsReadAgain) {
  const Folder folder;
  folder.write("other.csv", thrown(600));
  const Outcome outcome = fantail({"fly", "tasha3_launch2", "--trajectory", "other.csv", "--out", "out"},
                                  {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Until the trajectory ends at 6.00 s, before apogee: "), std::string::npos) << outcome.out;
  ASSERT_EQ(fantail({"report", "out", "--out", "again"}, {.working_folder = folder.path()}).exit_code, 0);
  for (const char* results : {"out", "again"}) {
    const json::Value summary = json::parse(content(std::filesystem::path{folder / results} / "summary.json"));
    EXPECT_EQ(summary["outcome"], "cut_short");
    EXPECT_NEAR(summary["trajectory_end_s"].number(), 6.0, 0.002);
    EXPECT_EQ(summary["verdict"].text().find("Until the trajectory ends at 6.00 s"), 0U) << summary["verdict"];
  }
}

TEST(FlyTrajectory, WhatCannotBeFlownIsRefusedBeforeAnythingIsWritten) {
  const Refusal missing{{}, {"fly", "--trajectory", "nowhere.csv"}, 66, {"nowhere.csv", "no such file"}};
  const Refusal empty{{{"a.csv", ""}}, {"fly", "--trajectory", "a.csv"}, 65, {"a.csv", "empty"}};
  const Refusal tunnel{{{"a.csv", thrown()}},
                       {"fly", "tunnel_steps", "--trajectory", "a.csv"},
                       78,
                       {"tunnel_steps", "environment.surroundings"}};
}

}  // namespace
}  // namespace fantail::test
