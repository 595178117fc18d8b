// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstdlib>

#include "system/refusal.hpp"

namespace fantail::test {
namespace {

using Names = std::vector<std::string>;
const Names results{"flight.csv", "flight.ftl", "report.html", "summary.json", "without_control.csv"};

json::Value summary(const std::string& folder) {
  return json::parse(content(std::filesystem::path{folder} / "summary.json"));
}

TEST(Fly, FliesTheSecondLaunchIntoAFolderOfItsNameWhenNothingIsSaid) {
  const Folder folder;
  const Outcome outcome = run_in(folder, {"fly"});
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(folder.listing(), (Names{"out", "out/tasha3_launch2", "out/tasha3_launch2/flight.csv",
                                     "out/tasha3_launch2/flight.ftl", "out/tasha3_launch2/report.html",
                                     "out/tasha3_launch2/summary.json", "out/tasha3_launch2/without_control.csv"}));
  expect_said(outcome.out, {"out/tasha3_launch2/report.html"});
  EXPECT_EQ(summary(folder / "out/tasha3_launch2")["scenario"], "tasha3_launch2");
}

TEST(Fly, NamesTheDefaultFolderAfterTheScenarioFile) {
  const Folder folder;
  folder.write("mine.v2.toml", "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n");
  EXPECT_EQ(fantail({"fly", "mine.v2.toml"}, {.working_folder = folder.path()}).exit_code, 0);
  EXPECT_EQ(summary(folder / "out/mine.v2")["scenario"], "mine.v2");
}

TEST(Fly, WritesItsFilesWhereItIsTold) {
  const Folder folder;
  const Outcome outcome = fantail({"fly", "tasha3_launch1", "--out", folder / "a new/folder"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(summary(folder / "a new/folder")["outcome"], "not_held") << "a verdict is no exit code";
  Names names;
  for (const auto& entry : std::filesystem::directory_iterator{folder / "a new/folder"}) {
    names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  EXPECT_EQ(names, results);
}

TEST(Fly, NamesEveryTableThatItWrote) {
  const Folder folder;
  for (const Names& words : {Names{"fly"}, Names{"fly", "--set", "flight.motion=six_dof"}, Names{"fly", "tunnel_steps"},
                             Names{"fly", "gimbal"}}) {
    Names asked = words;
    asked.insert(asked.end(), {"--out", "out"});
    const Outcome outcome = run_in(folder, asked);
    for (const auto& entry : std::filesystem::directory_iterator{folder / "out"}) {
      const std::string name = entry.path().filename().string();
      EXPECT_EQ(outcome.out.find("  data     out/" + name + "\n") != std::string::npos, name.ends_with(".csv")) << name;
    }
  }
}

TEST(Fly, ReplacesAnEarlierResultAndLeavesOtherFilesAlone) {
  const Folder folder;
  folder.write("out/summary.json", "an earlier result");
  folder.write("out/notes.txt", "mine");
  EXPECT_EQ(fantail({"fly", "--out", folder / "out"}).exit_code, 0);
  EXPECT_EQ(summary(folder / "out")["seed"], 1);
  EXPECT_EQ(content(folder / "out/notes.txt"), "mine");
  EXPECT_EQ(folder.listing().size(), 7U);  // the folder, five results, the notes: nothing temporary
}

// Three seconds: a start command that comes before the avionics can be armed is refused.
TEST(Fly, InRealTimeTakesAsLongAsTheFlightAndChangesNoByte) {
  const Folder folder;
  const Names scenario{"fly", "tunnel_steps", "--set", "timing.pad_time_s=1.5"};
  Names quick = scenario;
  quick.insert(quick.end(), {"--out", folder / "quick"});
  Names by_the_clock = scenario;
  by_the_clock.insert(by_the_clock.end(), {"--out", folder / "by_the_clock", "--realtime"});
  EXPECT_EQ(fantail(quick).exit_code, 0);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(fantail(by_the_clock).exit_code, 0);
  // Never less; how much more is the machine's business.
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::seconds{3});
  EXPECT_EQ(content(folder / "quick/flight.csv"), content(folder / "by_the_clock/flight.csv"));
}

TEST(Fly, GivesTheSameBytesForTheSameSeedAndOthersForAnother) {
  const Folder folder;
  for (const auto& [name, seed] : {std::pair{"a", "7"}, std::pair{"b", "7"}, std::pair{"c", "8"}}) {
    EXPECT_EQ(fantail({"fly", "tasha3_launch2", "--seed", seed, "--out", folder / name}).exit_code, 0);
  }
  for (const std::string& file : results) {
    EXPECT_EQ(content(folder / ("a/" + file)), content(folder / ("b/" + file))) << file;
    if (file != "without_control.csv") {  // nothing that is drawn rolls a rocket without control along a line
      EXPECT_NE(content(folder / ("a/" + file)), content(folder / ("c/" + file))) << file;
    }
  }
  EXPECT_EQ(summary(folder / "a")["seed"], 7);
  EXPECT_EQ(summary(folder / "c")["seed"], 8);
}

// Bytes must not depend on where they are written, or on the folder the program was called from.
TEST(Fly, GivesTheSameBytesFromAnotherFolderAndInAnotherLanguage) {
  const Folder folder;
  const Folder elsewhere;
  EXPECT_EQ(fantail({"fly", "--out", folder / "a"}).exit_code, 0);
  EXPECT_EQ(fantail({"fly", "--out", folder / "b/c"}, {.working_folder = elsewhere.path(),
                                                       .prepare =
                                                           [] {
                                                             setenv("LC_ALL", "de_DE.UTF-8", 1);
                                                             setenv("TZ", "Pacific/Auckland", 1);
                                                           }})
                .exit_code,
            0);
  for (const std::string& file : results) {
    EXPECT_EQ(content(folder / ("a/" + file)), content(folder / ("b/c/" + file))) << file;
  }
}

struct Change {
  const char* text;
  const char* where;
};

class FlySet : public testing::TestWithParam<Change> {};

TEST_P(FlySet, ReachesIntoPlanVehicleAndScenario) {
  const Folder folder;
  const Outcome changed = fantail({"fly", "--set", GetParam().text, "--out", folder / "changed"});
  EXPECT_EQ(changed.exit_code, 0) << changed.err;
  EXPECT_EQ(fantail({"fly", "--out", folder / "plain"}).exit_code, 0);
  EXPECT_NE(content(folder / "changed/flight.csv"), content(folder / "plain/flight.csv"));
}

INSTANTIATE_TEST_SUITE_P(EachFile, FlySet,
                         testing::Values(Change{"controller.canard_limit_deg=6", "plan"},
                                         Change{"body.mass_kg=3.5", "vehicle"},
                                         Change{"servo.lag_s=0.03", "vehicle, a key its file does not have"},
                                         Change{"launch_guide.tilt_deg=5", "scenario"},
                                         Change{"disturbance.angles_deg=[-3]", "scenario, a list"},
                                         Change{"reference.kind=hold", "plan, a word without quotes"}),
                         [](const auto& one) { return "Number" + std::to_string(one.index); });

TEST(Fly, TakesAChangeBeforeTheScenarioAndTheLastOfTwo) {
  const Folder folder;
  EXPECT_EQ(fantail({"fly", "--set", "body.mass_kg=9", "--set", "body.mass_kg=3.99", "tasha3_launch2", "--out",
                     folder / "twice"})
                .exit_code,
            0);
  EXPECT_EQ(fantail({"fly", "--out", folder / "plain"}).exit_code, 0);
  EXPECT_EQ(content(folder / "twice/flight.csv"), content(folder / "plain/flight.csv"));
}

TEST(Fly, PrintsOneJsonObjectAndNothingElse) {
  const Folder folder;
  const Outcome outcome = fantail({"fly", "tunnel_steps", "--json", "--out", folder / "out"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const json::Value printed = json::parse(outcome.out);  // throws when anything else is there
  ASSERT_TRUE(printed.is_object());
  EXPECT_EQ(outcome.out, content(folder / "out/summary.json"));
  for (const char* key : {"scenario", "seed", "events", "apogee_m", "max_speed_m_s", "control_start_height_m",
                          "saturated_fraction", "final_phase", "log_sha256", "version"}) {
    EXPECT_TRUE(printed.contains(key)) << key;
  }
  const std::string sum = run("sha256sum", {folder / "out/flight.ftl"}).out;
  EXPECT_EQ(printed["log_sha256"], sum.substr(0, 64));
}

TEST(Fly, WhatWasNeverArmedRecordsNothingAndAnOldLogDoesNotStay) {
  const Folder folder;
  folder.write("out/flight.ftl", "of an earlier flight");
  EXPECT_EQ(fantail({"fly", "--set", "timing.pad_time_s=2", "--out", folder / "out"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/flight.ftl"));
  EXPECT_TRUE(summary(folder / "out")["log_sha256"].is_null());
}

TEST(Fly, ATunnelRunLeavesTheTunnelsOwnLogBesideItAndAFlightDoesNot) {
  const Folder folder;
  EXPECT_EQ(fantail({"fly", "tunnel_steps", "--set", "run.control_time_s=3", "--out", folder / "out"}).exit_code, 0);
  const std::string log = content(folder / "out/tunnel.csv");
  EXPECT_EQ(log.substr(0, log.find('\n')), "time_s,fan_rpm,wind_speed_m_s");
  expect_said(log, {"\n0.000000,1250.000000,22."});
  EXPECT_EQ(std::ranges::count(log, '\n'), 8)
      << log;  // the header, ten seconds before control and three of it, one after
}

TEST(Fly, WritesTheColumnsThatScriptsRelyOn) {
  const Folder folder;
  EXPECT_EQ(fantail({"fly", "--out", folder / "out"}).exit_code, 0);
  const std::string csv = content(folder / "out/flight.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "time_s,phase,roll_angle_deg,roll_rate_deg_s,reference_deg,excitation_deg,offset_estimate_deg,command_deg,"
            "saturated,"
            "command_1_deg,command_2_deg,command_3_deg,command_4_deg,encoder_1_deg,encoder_2_deg,encoder_3_deg,"
            "encoder_4_deg,canard_deg,specific_force_m_s2,height_m,speed_m_s,true_roll_angle_deg,"
            "true_roll_rate_deg_s,true_canard_deg,true_height_m,true_speed_m_s,true_disturbance_deg");
  EXPECT_EQ(csv.back(), '\n');
  EXPECT_EQ(csv.find('#'), std::string::npos);
  EXPECT_EQ(csv.find("nan"), std::string::npos);
}

TEST(Fly, SaysThatRollWasImposed) {
  const Folder folder;
  const Outcome outcome = fantail({"fly", "tasha3_launch1", "--out", folder / "out"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_said(outcome.out, {"Roll was imposed by the scenario at 0.21 s"});
  EXPECT_NEAR(summary(folder / "out")["imposed_roll"]["rate_deg_s"].number(), 51.8, 1e-9);
  expect_said(content(folder / "out/report.html"), {"imposed"});
}

TEST(Fly, SaysWhatIsBrokenSinceWhenAndByHowMuch) {
  const Folder folder;
  const std::string head = "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n[[faults]]\nkind = ";
  const std::vector<std::pair<std::string, std::string>> said{
      {"\"canard_stuck\"\ncanard = 1\nfrom_s = -600\nangle_deg = 3\n",
       "Fault: canard_stuck, canard 1, jammed at 3 degrees, from power-up."},
      {"\"canard_stuck\"\ncanard = 1\nfrom_s = 2.5\n", "Fault: canard_stuck, canard 1, from 2.5 s after ignition."},
      {"\"canard_wrong_trim\"\ncanard = 3\nfrom_s = 0\n",
       "Fault: canard_wrong_trim, canard 3, 2.5 degrees off, from 0 s after ignition."},
      {"\"canard_slow\"\ncanard = 4\nfrom_s = -10\n", "Fault: canard_slow, canard 4, from power-up."},
      {"\"encoder_noisy\"\ncanard = 4\nfrom_s = -600\n",
       "Fault: encoder_noisy, canard 4, standard deviation 60 counts, from power-up."},
      {"\"imu_dropout\"\nfrom_s = 4\nuntil_s = 4.003\n", "Fault: imu_dropout from 4 to 4.003 s after ignition."},
      {"\"imu_dropout\"\nfrom_s = -600\nuntil_s = -4\n", "Fault: imu_dropout from power-up to -4 s after ignition."}};
  for (const auto& [fault, sentence] : said) {
    folder.write("broken.toml", head + fault);
    const Outcome outcome = run_in(folder, {"fly", "broken.toml"});
    expect_said(outcome.out, {sentence});
  }
}

// The README's example.
TEST(Fly, AWiderCanardLimitWouldHaveHeldTheFirstLaunch) {
  const Folder folder;
  for (const auto& [limit, expected] : {std::pair{"6", "not_held"}, std::pair{"9", "held"}}) {
    const std::string change = std::string{"controller.canard_limit_deg="} + limit;
    const Outcome outcome =
        fantail({"fly", "tasha3_launch1", "--set", "reference.kind=hold", "--set", change, "--out", folder / limit});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(summary(folder / limit)["outcome"], expected);
  }
}

// A rocket that stays on the pad is a result like any other: the run ends after burn-out and says what happened.
TEST(Fly, ARocketTooHeavyForItsMotorEndsOnThePadAndSaysSo) {
  const Folder folder;
  const Outcome outcome = fantail({"fly", "--set", "body.mass_kg=100", "--out", folder / "out"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_said(outcome.out, {"never left the pad"});
  const json::Value s = summary(folder / "out");
  EXPECT_TRUE(s["events"]["liftoff_s"].is_null());
  EXPECT_TRUE(s["events"]["apogee_s"].is_null());
  EXPECT_EQ(s["final_phase"], "armed");
}

// The vehicle and the motor lie beside the files that name them, wherever the program is called from.
TEST(Fly, FindsFilesBesideTheOneThatNamesThem) {
  const Folder folder;
  const std::string root = std::string{FANTAIL_TEST_SOURCE} + "/sim/";
  folder.write("mine/motor.eng", content(root + "motors/i150_canonical.eng"));
  std::string vehicle = content(root + "vehicles/tasha3_launch2.toml");
  const std::string shipped = "\"i150_canonical\"";
  vehicle.replace(vehicle.find(shipped), shipped.size(), "\"motor.eng\"");
  folder.write("mine/rocket.toml", vehicle);
  const std::string scenario = folder.write("mine/flight.toml",
                                            "vehicle = \"rocket.toml\"\nplan = \"tasha3_launch2\"\n[disturbance]\n"
                                            "times_s = [0]\nangles_deg = [-4.9]\n");
  const Outcome outcome = fantail({"fly", scenario, "--out", folder / "beside"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(fantail({"fly", "--out", folder / "plain"}).exit_code, 0);
  EXPECT_EQ(content(folder / "beside/flight.csv"), content(folder / "plain/flight.csv"));
}

}  // namespace
}  // namespace fantail::test
