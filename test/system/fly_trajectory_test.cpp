// SPDX-License-Identifier: MIT
#include <filesystem>

#include <fmt/core.h>

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
  const Outcome outcome = run_in(folder, {"fly", "tasha3_launch2", "--trajectory", "other.csv"});
  expect_said(outcome.out, {"The path of this flight is that of other.csv (1201 rows to 12.00 s)"});
  const std::filesystem::path results = std::filesystem::path{folder / "out/tasha3_launch2+trajectory=other.csv"};
  const json::Value summary = json::parse(content(results / "summary.json"));
  EXPECT_NEAR(summary["apogee_m"].number(), 400.0, 0.1);  // 80 + 80^2 / 20
  EXPECT_NEAR(summary["max_speed_m_s"].number(), 80.0, 0.1);
  EXPECT_NEAR(summary["events"]["apogee_s"].number(), 10.0, 0.02);
  EXPECT_EQ(summary["changes"][0], "trajectory=other.csv");
  expect_said(content(results / "report.html"), {"that of other.csv"});
  expect_said(content(results / "report.html"), {"The path"});
  EXPECT_EQ(content(results / "trajectory.csv").find("time_s,across_m,height_m,across_m_s,up_m_s,tilt_deg\n"), 0U);
  EXPECT_EQ(summary["notes"][1].text().find("The next 5 sentences are from vehicle and scenario."), 0U)
      << summary["notes"];
}

TEST(FlyTrajectory, OneThatEndsInTheClimbIsJudgedAsFarAsItReachesAlsoWhenItIsReadAgain) {
  const Folder folder;
  folder.write("other.csv", thrown(600));
  const Outcome outcome = run_in(folder, {"fly", "tasha3_launch2", "--trajectory", "other.csv", "--out", "out"});
  expect_said(outcome.out, {"Until the trajectory ends at 6.00 s, before apogee: "});
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

// How many rows of a flight are kept.

TEST(Fly, AScenarioMaySayHowManyRowsAreKept) {
  const Folder folder;
  const std::vector<std::string> short_run{"fly", "tunnel_swirl_with", "--set", "run.control_time_s=3", "--out"};
  const auto flown = [&](const char* name, const char* change) {
    std::vector<std::string> arguments = short_run;
    arguments.insert(arguments.end(), {folder / name, "--set", change});
    const Outcome outcome = fantail(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  };
  const std::string said = flown("thin", "timing.log_period_s=0.02");
  expect_said(said, {"a row every 0.02 s instead of every millisecond"});
  EXPECT_EQ(flown("full", "timing.log_period_s=0.001").find("instead of"), std::string::npos);
  const std::string thin = content(folder / "thin/flight.csv");
  const std::string full = content(folder / "full/flight.csv");
  EXPECT_EQ(std::ranges::count(full, '\n') / std::ranges::count(thin, '\n'), 19);  // 20 but for the header
  // What is kept is as it was.
  for (std::size_t begin = 0; begin < thin.size();) {
    const std::size_t end = thin.find('\n', begin) + 1;
    ASSERT_NE(full.find(thin.substr(begin, end - begin)), std::string::npos);
    begin = end;
  }
  EXPECT_EQ(content(folder / "thin/tunnel.csv"), content(folder / "full/tunnel.csv"));
}

TEST(Fly, HowManyRowsALaunchKeepsChangesNoFigure) {
  const Folder folder;
  const auto summary = [&folder](const char* period) {
    const std::vector<std::string> words{"fly", "--json", "--set", std::string{"timing.log_period_s="} + period};
    json::Value all = json::parse(fantail(words, {.working_folder = folder.path()}).out);
    all["notes"] = all["changes"] = all["made"] = nullptr;
    return all.pretty();
  };
  EXPECT_EQ(summary("0.001"), summary("1"));
}

TEST(FlyOn, APlaceThatDoesNotExistIsRefused) {
  Refusal{{},
          {"fly", "--on", "moon"},
          64,
          {"\"moon\" is not a flight computer; allowed: host, emulator, board, serial:DEVICE"}};
  Refusal{{}, {"fly", "--on", "serial:"}, 64, {"\"serial:\" is not a flight computer"}};
}

TEST(FlyOn, AnImageThatIsMissingIsNamed) {
  Refusal{{},
          {"fly", "--on", "emulator", "--image", "/nowhere/fantail-emulator.elf"},
          66,
          {"/nowhere/fantail-emulator.elf: no such file",
           "In the sources, ./dev fly --on emulator builds build/arm/fantail-emulator.elf"}};
}

// Whether there is one depends on what has been built.
TEST(FlyOn, TheImageIsLookedForWhereTheBuildLeavesIt) {
  const auto image = std::filesystem::path{fantail_path()}.parent_path().parent_path() / "arm/fantail-emulator.elf";
  const Folder folder;
  const Outcome outcome = fantail({"fly", "--on", "emulator", "--out", "flown"}, {.working_folder = folder.path()});
  if (std::filesystem::exists(image)) {
    EXPECT_EQ(outcome.err.find("no such file"), std::string::npos) << outcome.err;
  } else {
    EXPECT_EQ(outcome.exit_code, 66);
    EXPECT_NE(outcome.err.find(image.string() + ": no such file"), std::string::npos) << outcome.err;
  }
}

TEST(FlyOn, AResetIsRefusedWhereNobodyCanResetTheProcessor) {
  Refusal{{{"r.toml",
            "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n[[faults]]\nkind = \"reset\"\nfrom_s = 3\n"}},
          {"fly", "r.toml", "--on", "emulator"},
          78,
          {"r: faults.kind = \"reset\" cannot be flown with --on emulator; allowed: --on host"}};
}

TEST(FlyOn, ASerialDeviceThatIsMissingOrNoneIsNamed) {
  Refusal{{}, {"fly", "--on", "serial:/dev/there-is-none"}, 74, {"/dev/there-is-none: there is no such device"}};
  Refusal{{}, {"fly", "--on", "serial:/dev/null"}, 74, {"/dev/null: it is not a serial port"}};
}

}  // namespace

}  // namespace fantail::test
