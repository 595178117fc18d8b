// SPDX-License-Identifier: MIT
// What a result is made from is not replaced by it.
#include <filesystem>

#include <fmt/format.h>

#include "system/refusal.hpp"

namespace fantail::test {
namespace {

using Words = std::vector<std::string>;

/// A header, and rows of a number that grows by `step` with the same behind it.
std::string table(const std::string& header, int rows, double step, const std::string& rest) {
  std::string text = header + "\n";
  for (int i = 0; i < rows; ++i) {
    text += fmt::format("{:g}{}\n", step * i, rest);
  }
  return text;
}

/// 40 m/s2 for two seconds.
std::string climb() {
  std::string text = "Time (s),Altitude (m),Vertical velocity (m/s)\n";
  for (double t = 0.0; t < 2.0; t += 0.05) {
    text += fmt::format("{:.2f},{:.4f},{:.2f}\n", t, 20.0 * t * t, 40.0 * t);
  }
  return text;
}

const std::string roll = table("time_s,roll_angle_deg,roll_rate_deg_s,speed_m_s", 12, 1.0, ",0,0,20");
const std::string wind = table("time_s,fan_rpm,wind_speed_m_s", 8, 10.0, ",1250,22");
const std::string path = climb();
const std::string steps =
    "alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg\n20,9.5,-1,-2\n19,9,-2,-1\n21,10,-1.5,-1\n";
const std::string scenario = "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n";
const std::string spread =
    scenario + "[[spread]]\nfield = \"aerodynamics.damping_m2\"\nlaw = \"uniform\"\nlow = 18\nhigh = 20\n";

const std::string vehicle = content(std::filesystem::path{FANTAIL_TEST_SOURCE} / "sim/vehicles/tasha3_launch2.toml");
const std::string plan = content(std::filesystem::path{FANTAIL_TEST_SOURCE} / "firmware/plans/tasha3_launch2.toml");
const std::string rows = "damping,torque\n19,9\n20,9.5\n";

/// A command that would write over a file that it reads.
struct Endangered {
  const char* name;
  const char* file;  ///< in the working folder
  const std::string& text;
  Words words;
};

class Input : public testing::TestWithParam<Endangered> {};

TEST_P(Input, IsNotReplacedByWhatIsMadeFromIt) {
  const Folder folder;
  const auto& [name, file, text, words] = GetParam();
  folder.write("roll.csv", roll);
  folder.write("own.toml", "vehicle = \"o/summary.json\"\nplan = \"tasha3_launch2\"\n");
  folder.write("planned.toml", "vehicle = \"tasha3_launch2\"\nplan = \"o/flight.csv\"\n");
  folder.write("drawn.toml", scenario +
                                 "[[spread]]\nfields = [\"aerodynamics.damping_m2\", \"aerodynamics.torque_m\"]\n"
                                 "law = \"rows\"\ntable = \"o/summary.json\"\ncolumns = [\"damping\", \"torque\"]\n");
  folder.write(file, text);
  const Outcome outcome = run_in(folder, words, 74);
  expect_said(outcome.err, {std::string{file} + ": these results are made from it"});
  EXPECT_EQ(content(folder / file), text);
}

INSTANTIATE_TEST_SUITE_P(
    EachVerb, Input,
    testing::Values(
        Endangered{"Compare", "o/differences.csv", roll, {"compare", "o/differences.csv", "roll.csv", "--out", "o"}},
        Endangered{
            "CompareWith", "o/differences.csv", roll, {"compare", "roll.csv", "o/differences.csv", "--out", "o"}},
        Endangered{"Predict",
                   "o/runs.csv",
                   steps,
                   {"predict", "--tunnel", "o/runs.csv", "--swirl", "0", "--runs", "2", "--out", "o"}},
        Endangered{"PredictOneRun",
                   "o/flight.csv",
                   steps,
                   {"predict", "--tunnel", "o/flight.csv", "--swirl", "0", "--run", "0", "--out", "o"}},
        Endangered{"PredictScenario",
                   "o/predict.json",
                   scenario,
                   {"predict", "o/predict.json", "--tunnel", "tasha3_table2", "--runs", "2", "--out", "o"}},
        Endangered{"Fly", "o/summary.json", scenario, {"fly", "o/summary.json", "--out", "o"}},
        Endangered{"FlyTrajectory",
                   "o/trajectory.csv",
                   path,
                   {"fly", "tasha3_launch2", "--trajectory", "o/trajectory.csv", "--out", "o"}},
        Endangered{
            "TunePlan", "mine.toml", scenario, {"tune", "mine.toml", "--plan", "mine.toml", "--force", "--out", "o"}},
        Endangered{"FlyVehicle", "o/summary.json", vehicle, {"fly", "own.toml", "--out", "o"}},
        Endangered{"FlyPlan", "o/flight.csv", plan, {"fly", "planned.toml", "--out", "o"}},
        Endangered{"TuneVehicle",
                   "o/summary.json",
                   vehicle,
                   {"tune", "own.toml", "--plan", "o/summary.json", "--force", "--out", "t"}},
        Endangered{"CampaignTable", "o/summary.json", rows, {"campaign", "drawn.toml", "--runs", "1", "--out", "o"}},
        Endangered{"Campaign", "o/summary.json", spread, {"campaign", "o/summary.json", "--runs", "1", "--out", "o"}},
        Endangered{"TunnelFlow", "o/report.html", wind, {"tunnel", "flow", "o/report.html", "--out", "o"}},
        Endangered{"Listen",
                   "o/listen.json",
                   roll,
                   {"listen", "o/listen.json", "--columns", "time=time_s:s,axial=speed_m_s:m/s2", "--out", "o"}},
        Endangered{"Report", "o/flight.csv", roll, {"report", "o/flight.csv", "--out", "o"}}),
    [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace fantail::test
