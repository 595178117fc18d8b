// SPDX-License-Identifier: MIT

#include "system/refusal.hpp"

namespace fantail::test {
namespace {

const Words results{"band.csv", "predict.html", "predict.json", "runs.csv"};

json::Value prediction(const std::filesystem::path& folder) { return json::parse(content(folder / "predict.json")); }

TEST(Predict, TheFirstLaunchIsNoGoWithItsReasonAndEverythingIsWritten) {
  const Folder folder;
  const Outcome outcome = run_in(folder, {"predict", "tasha3_launch1", "--runs", "10"}, 1);
  EXPECT_EQ(outcome.err, "");
  expect_said(outcome.out, {"No go: the fin offset of about 7.", "larger than the 6 degree canard limit in ",
                            "seed 1\n", "hindsight", "Swirl subtracted: 0 degrees"});
  const std::filesystem::path written = folder.path() / "out/predict/tasha3_launch1";
  Words names;
  for (const auto& entry : std::filesystem::directory_iterator{written}) {
    names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  EXPECT_EQ(names, results);
  EXPECT_EQ(prediction(written)["go"], false);
  expect_said(content(written / "predict.html"), {"No go"});
}

TEST(Predict, TheSecondLaunchIsGo) {
  const Folder folder;
  const Outcome outcome = fantail({"predict", "--runs", "80", "--json", "--out", folder / "here"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
  const json::Value said = json::parse(outcome.out);
  EXPECT_EQ(said["scenario"], "tasha3_launch2");
  EXPECT_EQ(said["go"], true);
  EXPECT_EQ(said["tunnel"]["swirl_deg"], -2.0);
  EXPECT_EQ(said, prediction(folder / "here"));
}

TEST(Predict, GivesTheSameBytesForTheSameSeedWithOneThreadOrTwoAndOthersForAnotherSeed) {
  const Folder folder;
  for (const auto& [name, seed, threads] : {std::tuple{"a", "7", "1"}, {"b", "7", "2"}, {"c", "8", "2"}}) {
    (void)fantail({"predict", "--runs", "6", "--seed", seed, "--threads", threads, "--out", folder / name});
  }
  for (const std::string& file : results) {
    EXPECT_EQ(content(folder / ("a/" + file)), content(folder / ("b/" + file))) << file;
    EXPECT_NE(content(folder / ("a/" + file)), content(folder / ("c/" + file))) << file;
  }
  EXPECT_EQ(prediction(folder / "c")["seed"], 8);
}

/// The cells of a row of runs.csv, 0 being the first run.
std::vector<std::string> row_of(const std::string& csv, std::size_t number) {
  std::istringstream lines{csv};
  std::string line;
  for (std::size_t i = 0; i <= number + 1; ++i) {
    std::getline(lines, line);
  }
  std::vector<std::string> cells;
  std::istringstream row{line};
  for (std::string cell; std::getline(row, cell, ',');) {
    cells.push_back(cell);
  }
  return cells;
}

// The page and the JSON name the command; --runs makes no difference to a run.
TEST(Predict, ARunIsRepeatedByTheCommandThatThePageNames) {
  const Folder folder;
  const Words asked{
      "predict", "tasha3_launch2", "--set", "controller.canard_limit_deg=8", "--seed", "5", "--damping-factor",
      "1:1.6",   "--runs",         "4"};
  EXPECT_EQ(fantail(asked, {.working_folder = folder.path()}).err, "");
  const std::filesystem::path results_folder =
      folder.path() / "out/predict/tasha3_launch2+controller.canard_limit_deg=8+seed=5+damping-factor=1_1.6+";
  std::filesystem::path found;
  for (const auto& entry : std::filesystem::directory_iterator{folder.path() / "out/predict"}) {
    EXPECT_TRUE(entry.path().string().starts_with(results_folder.string())) << entry.path();
    found = entry.path();
  }
  const json::Value said = prediction(found);
  EXPECT_EQ(said["changes"], json::Value::array({"controller.canard_limit_deg=8", "seed=5", "damping-factor=1:1.6"}));
  const std::string command = said["repeat_run"].text();
  EXPECT_EQ(command,
            "fantail predict tasha3_launch2 --seed 5 --set controller.canard_limit_deg=8 --damping-factor 1:1.6 --run "
            "RUN");
  expect_said(content(found / "predict.html"), {"Changed on the command line: controller.canard_limit_deg=8, seed=5"});
  std::istringstream words{command};
  Words again;
  for (std::string word; words >> word;) {
    again.push_back(word == "RUN" ? "3" : word);
  }
  again.erase(again.begin());
  again.emplace_back("--json");
  const Outcome outcome = run_in(folder, again);
  const json::Value flight = json::parse(outcome.out);
  const std::vector<std::string> row = row_of(content(found / "runs.csv"), 3);
  EXPECT_EQ(flight["outcome"], row[7]);
  EXPECT_NEAR(flight["largest_hold_error_deg"].number(), std::stod(row[8]), 1.5e-6);
  EXPECT_NEAR(flight["saturated_fraction"].number(), std::stod(row[10]), 1.5e-6);
  EXPECT_NEAR(flight["max_speed_m_s"].number(), std::stod(row[11]), 1.5e-6);
  EXPECT_NEAR(flight["apogee_m"].number(), std::stod(row[12]), 1.5e-6);
  EXPECT_NEAR(flight["authority_margin_deg"].number(), std::stod(row[6]), 1e-4);
  EXPECT_TRUE(std::filesystem::exists(found / "run_3/report.html"));
}

TEST(Predict, FliesNoRowThatItsRunsDoNotHave) {
  Refusal({}, {"predict", "--runs", "80", "--run", "80"}, 64, {"--run 80", "--runs 80", "79"});
}

TEST(Predict, ResultsOfAChangedScenarioReplaceNoOthers) {
  const Folder folder;
  const auto predicted = [&folder](const Words& more) {
    Words words{"predict", "tasha3_launch1", "--runs", "2"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = fantail(words, {.working_folder = folder.path()});
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  };
  EXPECT_EQ(predicted({}).find("Changed"), std::string::npos);
  const std::string unchanged = content(folder.path() / "out/predict/tasha3_launch1/predict.json");
  const std::string text = predicted({"--set", "controller.canard_limit_deg=9"});
  expect_said(text, {". Changed on the command line: controller.canard_limit_deg=9.\nNo go:"});
  (void)predicted({"--set", "disturbance.angles_deg=[0, 1, 2, 3, 4]"});
  (void)predicted({"--set", "disturbance.angles_deg=[0,1, 2, 3, 4]"});
  (void)predicted({"--phase-margin", "0"});
  (void)predicted({"--set", "body.name=\"" + std::string(300, 'n') + '"', "--other-vehicle"});
  EXPECT_EQ(content(folder.path() / "out/predict/tasha3_launch1/predict.json"), unchanged);
  std::size_t folders = 0;
  for (const auto& entry : std::filesystem::directory_iterator{folder.path() / "out/predict"}) {
    EXPECT_LE(entry.path().filename().string().size(), 110U);
    ++folders;
  }
  EXPECT_EQ(folders, 6U);
}

constexpr const char* own_steps =
    "step,begin_s,alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg,a_column_more\n"
    "1,0,20,9.5,-11,-12,x\n2,5,19,9.0,-12,-11,y\n3,10,21,10,-11.5,-11,z\n";

TEST(Predict, TakesAFileOfOnesOwnWithTheSwirlThatIsGiven) {
  const Folder folder;
  folder.write("steps.csv", own_steps);
  const Outcome outcome =
      run_in(folder, {"predict", "--tunnel", "steps.csv", "--swirl", "-1.5", "--runs", "5", "--json"}, 1);
  const json::Value said = json::parse(outcome.out);
  EXPECT_EQ(said["tunnel"]["file"], "steps.csv");
  EXPECT_EQ(said["tunnel"]["swirl_deg"], -1.5);
  EXPECT_NEAR(said["offset_size_deg"]["mean"].number(), 10.2, 1.0);
  EXPECT_EQ(said["authority"]["count"], 0);
}

TEST(Predict, FindsTheFileThatAScenarioNamesBesideIt) {
  const Folder folder;
  folder.write("mine/steps.csv", own_steps);
  folder.write("mine/flight.toml",
               "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\ntunnel_result = \"steps.csv\"\n");
  const Outcome outcome = run_in(folder, {"predict", "mine/flight.toml", "--swirl", "0", "--runs", "3"}, 1);
  expect_said(outcome.out, {"the 3 rows of steps.csv"});
}

TEST(Predict, RefusesWhatItCannotPredictFromAndWritesNothing) {
  const std::string flight = "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n";
  for (const Words& more : {Words{"--swirl", "1"},
                            {"--runs", "9"},
                            {"--run", "1"},
                            {"--held-percent", "80"},
                            {"--authority-percent", "80"},
                            {"--damping-factor", "1:2"},
                            {"--other-vehicle"}}) {
    Words words{"predict", "mine.toml"};
    words.insert(words.end(), more.begin(), more.end());
    Refusal({{"mine.toml", flight}}, words, 64, {more.front() + ": ", "mine names no tunnel_result", "--tunnel FILE"});
  }
  Refusal({{"mine.toml", "tunnel_result = \"absent\"\n" + flight}}, {"predict", "mine.toml"}, 66,
          {"mine.toml:1: unknown tunnel result \"absent\"", "tasha3_table2"});
  Refusal({}, {"predict", "--tunnel", "tasha3_tabel2"}, 66, {"did you mean tasha3_table2?"});
  Refusal({}, {"predict", "--tunnel", "absent.csv"}, 66, {"absent.csv: no such file"});
  Refusal({{"steps.csv", "alpha_m2,beta_m\n19,9\n"}}, {"predict", "--tunnel", "steps.csv"}, 65,
          {"disturbance_begin_deg", "alpha_m2"});
  Refusal({}, {"predict", "tunnel_steps"}, 78, {"tunnel_steps: environment.surroundings"});
  Refusal({{"steps.csv", own_steps}}, {"predict", "--tunnel", "steps.csv"}, 78,
          {"steps.csv: the swirl of the tunnel is not given", "--swirl DEG"});
}

// Two rows used to be "Go" with a remark, and another rocket's rows were taken without a word.
TEST(Predict, RefusesTooFewRowsAndThoseOfAnotherVehicleAndTakesTheseOnPurpose) {
  const std::string header = "alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg,vehicle\n";
  Refusal({{"steps.csv", header + "20,9.5,-1,-2,Dart\n19,9,-2,-1,Dart\n"}}, {"predict", "--tunnel", "steps.csv"}, 65,
          {"steps.csv: has 2 of the rows", "3 or more"});
  const std::string dart = header + "20,9.5,-1,-2,Dart\n19,9,-2,-1,Dart\n21,9,-1,-1,Dart\n";
  Refusal({{"steps.csv", dart}}, {"predict", "--tunnel", "steps.csv", "--swirl", "0"}, 78,
          {"steps.csv: its rows are of the vehicle \"Dart\"", "tasha3_launch2 flies \"Tasha III, launch 2\"",
           "--other-vehicle"});
  const Folder folder;
  folder.write("steps.csv", dart);
  const Outcome outcome =
      run_in(folder, {"predict", "--tunnel", "steps.csv", "--swirl", "0", "--other-vehicle", "--runs", "2"}, 1);
  expect_said(outcome.out, {"accepted for Tasha III, launch 2 on purpose"});
}

TEST(Predict, RefusesOptionsThatMeanNothing) {
  Refusal({}, {"predict", "--runs", "0"}, 64, {"--runs"});
  Refusal({}, {"predict", "--damping-factor", "2:1"}, 64, {"LOW:HIGH"});
  Refusal({}, {"predict", "--damping-factor", "low"}, 64, {"LOW:HIGH"});
  Refusal({}, {"predict", "--servo-lag", "20"}, 64, {"--servo-lag"});
  Refusal({}, {"predict", "--authority-percent", "100"}, 64, {"--authority-percent"});
}

TEST(Predict, LowerDemandsCanBeMade) {
  const Folder folder;
  const Words asked{"predict", "tasha3_launch1", "--runs", "10",   "--authority-percent", "0", "--held-percent",
                    "0",       "--phase-margin", "10",     "--out"};
  Words words = asked;
  words.push_back(folder / "out");
  EXPECT_EQ(fantail(words).exit_code, 0);
}

}  // namespace
}  // namespace fantail::test
