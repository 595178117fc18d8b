// SPDX-License-Identifier: MIT

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/made_tunnel_log.hpp"
#include "system/process.hpp"
#include "system/refusal.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

void expect_inside(double truth, const json::Value& interval) {
  EXPECT_LE(interval[0].number(), truth);
  EXPECT_GE(interval[1].number(), truth);
}

class IdentifiedFlight : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<Folder>();
    ASSERT_EQ(fantail({"fly", "tasha3_launch2"}, {.working_folder = folder_->path()}).exit_code, 0);
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::unique_ptr<Folder> folder_;
};
std::unique_ptr<Folder> IdentifiedFlight::folder_;

TEST_F(IdentifiedFlight, GivesWhatItWasFlownWith) {
  const auto json = identified(*folder_, identify("out/tasha3_launch2", {"--json"}));
  EXPECT_EQ(json["window"], "control");
  EXPECT_EQ(json["alpha_identifiable"], true);
  EXPECT_NEAR(json["alpha_m2"].number(), 23.0, 0.5);
  EXPECT_NEAR(json["beta_m"].number(), 9.0, 0.2);
  expect_inside(23.0, json["alpha_interval_m2"]);
  expect_inside(9.0, json["beta_interval_m"]);
  EXPECT_NEAR(json["disturbance_deg"][0].number(), -4.9, 0.02);
  // The flight plan's chirp, up to 18 Hz.
  const auto& response = json["frequency_response"];
  EXPECT_EQ(response["instrument"], "excitation");
  EXPECT_GE(response["lines"].size(), 40U);
  EXPECT_NEAR(response["lines"][3]["gain_per_s"].number() / response["lines"][3]["model_gain_per_s"].number(), 1.0,
              0.02);
  const auto& inputs = json["made"]["inputs"];
  ASSERT_EQ(inputs.size(), 4U) << "all that is read of the folder, and the vehicle";
  EXPECT_EQ(inputs[0]["file"], "tasha3_launch2/flight.csv");
  EXPECT_EQ(inputs[1]["sha256"], json::parse(content(*folder_ / "out/tasha3_launch2/summary.json"))["log_sha256"]);
  EXPECT_EQ(inputs[2]["file"], "tasha3_launch2/summary.json");
  for (const char* name : {"report.html", "model.csv", "identification.json"}) {
    EXPECT_GT(content(*folder_ / (std::string{"out/identify/tasha3_launch2/"} + name)).size(), 500U) << name;
  }
}

TEST_F(IdentifiedFlight, GivesItVeryNearlyFromTheTruth) {
  const auto json =
      identified(*folder_, identify("out/tasha3_launch2/", {"--json", "--truth", "--method", "both", "--out", "t"}));
  ASSERT_EQ(json["results"].size(), 2U);
  EXPECT_EQ(json["results"][0]["alpha_m2"], 23.0);
  EXPECT_EQ(json["results"][0]["beta_m"], 9.0);
  EXPECT_NEAR(json["results"][1]["alpha_m2"].number(), 23.0, 0.01);
  EXPECT_NEAR(json["results"][1]["beta_m"].number(), 9.0, 0.004);
  EXPECT_NEAR(json["results"][1]["disturbance_deg"][1].number(), -4.9, 0.001);
}

// The summary says what flew, and with what it was changed; nobody has to remember it.
TEST_F(IdentifiedFlight, BringsItsVehicleAlong) {
  auto json = identified(*folder_, {"identify", "out/tasha3_launch2", "--json", "--out", "own"});
  auto named = identified(*folder_, identify("out/tasha3_launch2", {"--json", "--out", "named"}));
  json["made"] = named["made"] = nullptr;  // by two commands
  EXPECT_EQ(json, named);
  const Outcome text = fantail({"identify", "out/tasha3_launch2/flight.ftl"}, {.working_folder = folder_->path()});
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_NE(text.out.find("tasha3_launch2 (summary.json), I 0.00393 kg m2"), std::string::npos) << text.out;
  // Every flight.ftl would have one folder.
  EXPECT_TRUE(std::filesystem::exists(*folder_ / "out/identify/tasha3_launch2/report.html")) << text.out;
  EXPECT_FALSE(std::filesystem::exists(*folder_ / "out/identify/flight")) << text.out;
}

// Nobody would see it: a damping and a torque that are off by the ratio of the inertias.
TEST_F(IdentifiedFlight, WithTheSummaryOfAnotherFlightIsRefusedByEveryVerbThatReadsIt) {
  std::string summary = content(*folder_ / "out/tasha3_launch2/summary.json");
  const std::size_t digits = summary.find(json::parse(summary)["log_sha256"].text());
  ASSERT_NE(digits, std::string::npos);
  summary[digits] = summary[digits] == '0' ? '1' : '0';
  const std::string log = content(*folder_ / "out/tasha3_launch2/flight.ftl");
  const std::vector<std::pair<std::string, std::string>> files{{"day/summary.json", summary}, {"day/flight.ftl", log}};
  for (const Words& words : {Words{"identify", "day"},
                             {"identify", "day/flight.ftl"},
                             {"identify", "day/flight.ftl", "--vehicle", "tasha3_launch1"},
                             {"tunnel", "steps", "day", "--speed", "22"},
                             {"tunnel", "stability", "day"},
                             {"compare", "day", "day"},
                             {"report", "day", "day"},
                             {"report", "day"}}) {
    Refusal(files, words, 65,
            {"day: its files are of two flights: flight.ftl does not have the SHA-256 that summary.json"});
  }
}

TEST_F(IdentifiedFlight, AnotherVehicleThanTheOneThatFlewIsUsedAndNamed) {
  const Outcome outcome = fantail({"identify", "out/tasha3_launch2", "--area", "1e-4", "--out", "other"},
                                  {.working_folder = folder_->path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* part : {"tasha3_launch2 (summary.json), I 0.00393 kg m2, A 0.0001 m2",
                           "was simulated with the vehicle tasha3_launch2", "A 5.0265e-05 m2"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part << "\n" << outcome.out;
  }
}

TEST(Identify, TakesTheVehicleAsItFlewNotAsItsFileSays) {
  const Folder folder;
  ASSERT_EQ(fantail({"fly", "tasha3_launch2", "--set", "body.roll_inertia_kg_m2=0.005", "--out", "heavy"},
                    {.working_folder = folder.path()})
                .exit_code,
            0);
  const auto json = identified(folder, {"identify", "heavy", "--json"});
  EXPECT_EQ(json["inertia_kg_m2"].number(), 0.005);
  EXPECT_NEAR(json["alpha_m2"].number(), 23.0, 0.5);
}

TEST_F(IdentifiedFlight, HasHubersLossForOneContinuousFitOfTheOpenLoop) {
  const auto json =
      identified(*folder_, identify("out/tasha3_launch2", {"--json", "--loss", "huber", "--out", "huber"}));
  EXPECT_EQ(json["loss"], "huber");
  EXPECT_NEAR(json["alpha_m2"].number(), 23.0, 0.5);
  EXPECT_GT(json["huber_threshold_deg"].number(), 0.0);
  for (const std::vector<std::string>& other : {std::vector<std::string>{"--method", "both"},
                                                {"--loop", "closed", "--plan", "tasha3_launch2"},
                                                {"--fit-lag"}}) {
    std::vector<std::string> words{"--loss", "huber", "--out", "refused"};
    words.insert(words.end(), other.begin(), other.end());
    const Outcome outcome = fantail(identify("out/tasha3_launch2", words), {.working_folder = folder_->path()});
    EXPECT_EQ(outcome.exit_code, 64) << other[0];
    EXPECT_NE(outcome.err.find("--loss huber: allowed with"), std::string::npos) << outcome.err;
  }
}

TEST_F(IdentifiedFlight, HasWindowsByItsEvents) {
  const auto json = identified(*folder_, identify("out/tasha3_launch2", {"--json", "--window", "thrust", "--window",
                                                                         "step:1", "--window", "1:2", "--out", "w"}));
  ASSERT_EQ(json["results"].size(), 3U);
  EXPECT_EQ(json["results"][0]["window"], "thrust");
  EXPECT_NEAR(json["results"][0]["window_begin_s"].number(), 0.638, 0.005);
  EXPECT_NEAR(json["results"][1]["window_begin_s"].number(), 2.638, 0.005);  // two seconds after control start
  EXPECT_EQ(json["results"][2]["samples"], 1001);
  const auto nodes =
      identified(*folder_, identify("out/tasha3_launch2", {"--json", "--nodes", "thrust:2,coast:2", "--out", "n"}));
  EXPECT_EQ(nodes["node_time_s"].size(), 5U);
}

TEST_F(IdentifiedFlight, MayBeLeftToTheController) {
  // The flown servos lag by more than the 20 ms of their first order alone, so only roughly.
  const auto json =
      identified(*folder_, identify("out/tasha3_launch2", {"--json", "--loop", "closed", "--plan", "tasha3_launch2",
                                                           "--servo-lag", "0.02", "--window", "0.9:5", "--out", "c"}));
  EXPECT_EQ(json["loop"], "closed");
  EXPECT_NEAR(json["alpha_m2"].number(), 23.0, 0.2 * 23.0);
  EXPECT_NEAR(json["beta_m"].number(), 9.0, 0.2 * 9.0);
  EXPECT_NEAR(json["disturbance_deg"][0].number(), -4.9, 0.2);
  // Frames and delay count as lag; no play of one servo is that of the mean of four.
  EXPECT_NEAR(json["servo_lag_s"].number(), 0.026, 0.004);
  EXPECT_LT(json["servo_lag_interval_s"][0].number(), json["servo_lag_s"].number());
  EXPECT_GE(json["servo_play_deg"].number(), 0.0);
  EXPECT_LT(json["servo_play_deg"].number(), 0.3);
  EXPECT_NE(json["remarks"].dump().find("not the 20 ms of --servo-lag"), std::string::npos) << json["remarks"];
  EXPECT_NE(json["remarks"].dump().find("So the model is incomplete"), std::string::npos) << json["remarks"];
}

TEST(Identify, PrintsATableForPeople) {
  const Folder folder;
  folder.write("run.csv", text(tunnel_rows(shaken)));
  const Outcome outcome = fantail(identify("run.csv", {"--method", "both"}), {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* part : {"run.csv: ", "grid, open loop", "continuous, open loop", "damping alpha, m2",
                           "This window determines damping and torque: Alpha is ", "out/identify/run/report.html"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part << "\n" << outcome.out;
  }
}

TEST(Identify, SaysWhenCanardsThatStandStillTellNothing) {
  const Folder folder;
  std::vector<Row> rows = tunnel_rows([](double) { return 5.0; });
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    rows[i].rate_deg_s = 0.01;  // of the gyro
  }
  folder.write("still.csv", text(rows));
  const auto json = identified(folder, identify("still.csv", {"--json"}));
  EXPECT_EQ(json["alpha_identifiable"], false);
  EXPECT_NE(json["verdict"].text().find("no excitation"), std::string::npos) << json["verdict"];
}

TEST(Identify, LeavesAFewRowsWithoutNumbersOutAndSaysSo) {
  const Folder folder;
  std::vector<Row> rows = tunnel_rows(shaken);
  rows[100].angle_deg = std::nan("");
  folder.write("run.csv", text(rows));
  const auto json = identified(folder, identify("run.csv", {"--json"}));
  EXPECT_NEAR(json["alpha_m2"].number(), 20.0, 0.1);
  EXPECT_NE(json["remarks"].dump().find("1 of 501 rows have no number"), std::string::npos) << json["remarks"];
}

TEST(Identify, DoubtsRadiansInADegreeColumn) {
  const Folder folder;
  std::vector<Row> rows = tunnel_rows(shaken);
  for (Row& row : rows) {
    row = {row.time_s, row.angle_deg / degrees, row.rate_deg_s / degrees, row.canard_deg / degrees};
  }
  folder.write("run.csv", text(rows));
  const Outcome outcome = fantail(identify("run.csv"), {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("look like radians"), std::string::npos) << outcome.out;
}

TEST(Identify, RefusesWhatIsNoLog) {
  const std::string good = text(tunnel_rows(shaken));
  Refusal({}, identify("none.csv"), 66, {"none.csv: no such file"});
  Refusal({{"folder/other", ""}}, identify("folder"), 66, {"folder: this folder contains no flight.csv"});
  Refusal({{"a.csv", ""}}, identify("a.csv"), 65, {"a.csv: is empty"});
  Refusal({{"a.csv", "time_s,roll_angle,roll_rate_deg_s,canard_deg,speed_m_s\n1,2,3,4,5\n"}}, identify("a.csv"), 65,
          {"a.csv: no column roll_angle_deg", "did you mean roll_angle?", "the columns are: time_s, roll_angle"});
  Refusal({{"a.csv", head + "0,1,2,3,22\n0.2,1,2,3,22\n0.1,1,2,3,22\n"}}, identify("a.csv"), 65,
          {"a.csv:4: time_s is 0.1 after 0.2 in line 3: time must increase"});
  Refusal({{"a.csv", good + "6,nan,2,3,22\n7,nan,2,3,22\n8,,2,3,22\n9,1,2,,22\n10,1,2,,22\n11,1,2,,22\n"}},
          identify("a.csv"), 65, {"a.csv: 6 of 507 rows", "line 503, roll_angle_deg \"nan\"", "1 %"});
  Refusal({{"a.csv", head + "0,1,2,3\n"}}, identify("a.csv"), 65, {"a.csv:2: 4 cells where the header has 5"});
}

TEST(Identify, RefusesAWindowThatCannotBe) {
  const std::string good = text(tunnel_rows(shaken));
  Refusal({{"a.csv", good}}, identify("a.csv", {"--window", "20:25"}), 65, {"outside the data", "0 s to 5 s"});
  Refusal({{"a.csv", good}}, identify("a.csv", {"--from", "2", "--to", "2.035"}), 65, {"4 samples for 4 unknowns"});
  Refusal({{"a.csv", good}}, identify("a.csv", {"--window", "boost"}), 78, {"--window boost", "control, thrust"});
  Refusal({{"a.csv", good}}, identify("a.csv", {"--window", "control"}), 65, {"no column phase"});
  Refusal({{"a.csv", good}}, identify("a.csv", {"--from", "3", "--to", "2"}), 78, {"after its end"});
  Refusal({{"a.csv", good}}, identify("a.csv", {"--nodes", "5,0"}), 78, {"--nodes 5,0", "auto"});
}

TEST(Identify, RefusesToGuessASpeed) {
  Refusal({{"a.csv", "time_s,roll_angle_deg,roll_rate_deg_s,canard_deg\n0,1,2,3\n1,1,2,3\n"}}, identify("a.csv"), 65,
          {"no column speed_m_s", "--speed"});
  std::string standing = head;
  for (int i = 0; i < 20; ++i) {
    standing += "0." + std::to_string(i + 10) + ",1,2,3,0.01\n";
  }
  Refusal({{"a.csv", standing}}, identify("a.csv"), 65, {"no speed", "--speed", "--truth"});
}

TEST(Identify, AsksWhichRocket) {
  const std::string good = text(tunnel_rows(shaken));
  Refusal({{"a.csv", good}}, {"identify", "a.csv"}, 64, {"no rocket given", "--inertia", "tasha3_launch2", "smokey"});
  Refusal({{"a.csv", good}}, {"identify", "a.csv", "--inertia", "0.004"}, 64, {"no rocket given"});
  Refusal({{"a.csv", good}}, {"identify", "a.csv", "--vehicle", "tasha"}, 66, {"unknown vehicle", "did you mean"});
}

TEST(Identify, RefusesOptionsThatMakeNoSense) {
  const std::string good = text(tunnel_rows(shaken));
  Refusal({{"a.csv", good}}, identify("a.csv", {"--units", "grad"}), 64, {"--units"});
  Refusal({{"a.csv", good}}, identify("a.csv", {"--column", "phi"}), 64, {"--column", "OURS=THEIRS"});
  Refusal({{"a.csv", good}}, identify("a.csv", {"--column", "roll=phi"}), 78, {"unknown column \"roll\""});
  Refusal({{"a.csv", good}}, identify("a.csv", {"--speed", "nan"}), 64, {"--speed", "0.1 to 10000"});
  Refusal({{"a.csv", good}}, identify("a.csv", {"--density", "thin"}), 78, {"--density thin"});
  Refusal({{"a.csv", good}}, identify("a.csv", {"--grid-beta", "5:15"}), 64, {"FIRST:LAST:STEP"});
  Refusal({{"a.csv", good}}, identify("a.csv", {"--loop", "closed"}), 64, {"--plan", "--kp"});
  Refusal({{"a.csv", good}}, identify("a.csv", {"--loop", "closed", "--plan", "tasha3_launch2", "--fit-lag"}), 64,
          {"--fit-lag", "--loop open"});
  Refusal({{"a.csv", good}}, identify("a.csv", {"--loop", "closed", "--plan", "tasha3_launch2"}), 65,
          {"no column reference_deg"});
  Refusal({{"a.csv", good}}, identify("a.csv", {"--window", "1:2", "--from", "1"}), 64, {"--from", "--window"});
  Refusal({{"a.csv", good}, {"file", ""}}, identify("a.csv", {"--out", "file/folder"}), 74, {"file"});
}

}  // namespace
}  // namespace fantail::test
