// SPDX-License-Identifier: MIT
#include <filesystem>

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "system/refusal.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

namespace fs = std::filesystem;

Words faults_of(const char* device, const char* phase, const std::string& out) {
  return {"campaign", "faults",  "tasha3_launch2", "--device", device, "--phase",
          phase,      "--every", "1000",           "--out",    out};
}

TEST(CampaignFaults, WritesPageAndSummaryAndBesideThemTheReportsOfItsWorstFlights) {
  const Folder folder;
  const Outcome outcome = fantail(faults_of("arm_switch", "launched", folder / "all"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("12 flights in 4 cells. No cell is RED."), std::string::npos) << outcome.out;
  const json::Value said = json::parse(content(folder / "all/summary.json"));
  EXPECT_EQ(said["flights"], 12);
  EXPECT_EQ(said["red"], 0);
  const std::string page = content(folder / "all/faults.html");
  for (const json::Value& cell : said["cells"]) {
    const std::string report = cell["worst"]["report"].text();
    EXPECT_TRUE(fs::exists(fs::path{folder / "all"} / report)) << report;
    EXPECT_NE(page.find("href=\"" + report + "\""), std::string::npos) << report;
  }
}

TEST(CampaignFaults, OneRunAgainWritesTheSameReportAndSaysWhatTheFailedServoMayDo) {
  const Folder folder;
  Words words = faults_of("servo", "launched", folder / "all");
  words.insert(words.end(), {"--fault", "hardover_back"});
  ASSERT_EQ(fantail(words).exit_code, 0) << "a known limit";
  const json::Value cell = json::parse(content(folder / "all/summary.json"))["cells"][0];
  ASSERT_EQ(cell["result"], "known limit");
  const std::string run = std::to_string(cell["worst"]["run"].count());
  const Outcome outcome = fantail({"campaign", "faults", "tasha3_launch2", "--every", "1000", "--cell",
                                   "servo/hardover_back/launched", "--run", run, "--out", folder / "again"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << "a known limit, as the whole campaign says";
  EXPECT_NE(outcome.out.find("the failed canard may stand anywhere up to its mechanical stop"), std::string::npos)
      << outcome.out;
  const std::string flight = "/servo.hardover_back.launched_run_" + run + "/flight.csv";
  EXPECT_EQ(content(folder / ("again" + flight)), content(folder / ("all" + flight)));
}

TEST(CampaignFaults, OfADeviceThatTheRocketFliesWithoutIsRefusedAsARunAloneIs) {
  const std::string why = "second_imu: the rocket does not use a second IMU";
  Refusal({}, faults_of("second_imu", "pad", "x"), 78, {why});
  Refusal({}, {"campaign", "faults", "tasha3_launch2", "--cell", "second_imu/dead/pad", "--out", "x"}, 78, {why});
}

TEST(CampaignFaults, AnEmptyWordDoesNotMeanAll) {
  for (const char* option : {"--device", "--fault", "--cell"}) {
    Refusal({}, {"campaign", "faults", option, "", "--out", "x"}, 64, {option, "is empty"});
  }
}

TEST(CampaignFaults, TheListIsTextAlone) { Refusal({}, {"campaign", "faults", "--list", "--json"}, 64, {"--json"}); }

}  // namespace
}  // namespace fantail::test
