// SPDX-License-Identifier: MIT
#include <fstream>

#include "flight_log/made_flight.hpp"
#include "system/refusal.hpp"

namespace fantail::test {
namespace {

using Json = json::Value;

std::string made_log() { return test::as_text(flight_log::make_flight().bytes); }

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream{path, std::ios::binary}.rdbuf();
  return text.str();
}

// angle + rate t in degrees, ten times a second for ten seconds.
std::string line(double angle, double rate) {
  std::string text = "time_s,roll_angle_deg,roll_rate_deg_s,speed_m_s\n";
  for (int i = 0; i <= 100; ++i) {
    const double t = i / 10.0;
    text += std::to_string(t) + "," + std::to_string(angle + rate * t) + "," + std::to_string(rate) + ",30\n";
  }
  return text;
}

TEST(Report, OfAFlightLogIsThePageAndTheDataThatFlyWrites) {
  const Folder folder;
  folder.write("flown.ftl", made_log());
  const Outcome outcome = run_in(folder, {"report", "flown.ftl", "--json"});
  const Json summary = json::parse(outcome.out);
  EXPECT_TRUE(summary["seed"].is_null());
  EXPECT_EQ(summary["phase_changes"][summary["phase_changes"].size() - 1]["phase"], summary["final_phase"]);
  EXPECT_FALSE(summary["events"]["detected_s"].is_null());
  EXPECT_EQ(content(folder / "out/report/flown/summary.json"), outcome.out);
  expect_said(content(folder / "out/report/flown/report.html"), {"launch detected"});
  const Outcome table =
      fantail({"log", "export", "flown.ftl", "--to", "csv", "--out", "-"}, {.working_folder = folder.path()});
  EXPECT_EQ(content(folder / "out/report/flown/flight.csv"), table.out);
}

// A board's log cannot be made again.
TEST(Report, NeverReplacesOrRemovesAFlightsOwnFiles) {
  const Folder folder;
  folder.write("day/flight.ftl", made_log());
  folder.write("other.ftl", made_log());
  for (const char* input : {"day/flight.ftl", "day", "other.ftl"}) {
    const Outcome outcome = run_in(folder, {"report", input, "--out", "day"}, 74);
    expect_said(outcome.err, {"day/flight.ftl: this folder has the files of a flight"});
    EXPECT_EQ(content(folder / "day/flight.ftl"), made_log());
    EXPECT_EQ(content(folder / "day/flight.csv"), "");
  }
  const Outcome exported =
      run_in(folder, {"log", "export", "day/flight.ftl", "--to", "json", "--out", "day/flight.ftl"}, 74);
  EXPECT_EQ(content(folder / "day/flight.ftl"), made_log());
}

TEST(Report, OfATableFromElsewhereShowsWhatItHasAndNoMore) {
  const Folder folder;
  folder.write("old.csv", line(5.0, 36.0));
  const Outcome outcome = run_in(folder, {"report", "old.csv", "--out", "page", "--json"});
  const Json summary = json::parse(outcome.out);
  EXPECT_EQ(summary["max_speed_m_s"], 30.0);
  for (const char* key : {"vehicle", "plan", "seed", "final_phase", "saturated_fraction", "authority_margin_deg"}) {
    EXPECT_TRUE(summary[key].is_null()) << key;
  }
  EXPECT_EQ(summary["outcome"], "not_judged");
}

TEST(Report, OfAFolderOfFlySaysTheSameAsFly) {
  const Folder folder;
  const Outcome flown = run_in(folder, {"fly", "--out", "flown", "--json"});
  const Outcome outcome = run_in(folder, {"report", "flown", "--json"});
  const Json before = json::parse(flown.out);
  const Json after = json::parse(outcome.out);
  for (const char* key : {"scenario", "vehicle", "plan", "seed", "events", "apogee_m", "max_speed_m_s",
                          "control_time_s", "saturated_fraction", "phase_changes", "canard_verdicts", "notes",
                          "final_phase", "roll_turns_without_control"}) {
    EXPECT_EQ(after[key], before[key]) << key;
  }
  EXPECT_FALSE(after["roll_turns_without_control"].is_null());
  EXPECT_EQ(content(folder / "out/report/flown/flight.csv"), content(folder / "flown/flight.csv"));
  expect_said(content(folder / "out/report/flown/report.html"), {"<code>fantail report flown</code>"});
  expect_said(content(folder / "flown/report.html"), {"<code>fantail fly tasha3_launch2</code>"});
}

TEST(Report, OfAFolderOfFlySaysWhatWasChangedOnTheCommandLine) {
  const Folder folder;
  const Outcome flown = run_in(folder, {"fly", "--set", "controller.canard_limit_deg=8", "--out", "flown"});
  const Outcome outcome = fantail({"report", "flown"}, {.working_folder = folder.path()});
  for (const std::string& out : {flown.out, outcome.out}) {
    expect_said(out, {"\nChanged on the command line: controller.canard_limit_deg=8.\n"});
  }
}

// A file system takes names of 255 bytes.
TEST(Report, OfTwoFlightsWithLongNamesHasAFolderWithAShorterOne) {
  const Folder folder;
  const std::string a(200, 'a');
  const std::string b(200, 'b');
  folder.write(a + ".csv", line(1.0, 20.0));
  folder.write(b + ".csv", line(0.0, 19.0));
  folder.write(b + "b.csv", line(0.0, 18.0));
  EXPECT_EQ(run_in(folder, {"report", a + ".csv", b + ".csv"}).exit_code, 0);
  EXPECT_EQ(run_in(folder, {"report", a + ".csv", b + "b.csv"}).exit_code, 0);
  const std::filesystem::directory_iterator pages{folder.path() / "out/report"};
  EXPECT_EQ(std::distance(begin(pages), end(pages)), 2) << "one of each pair";
}

TEST(Report, OfTwoFlightsHasTheDifferencesOfCompare) {
  const Folder folder;
  folder.write("a.csv", line(1.0, 20.0));
  folder.write("b.csv", line(0.0, 19.0));
  const Outcome outcome = run_in(folder, {"report", "a.csv", "b.csv", "--from", "2", "--to", "4", "--json"});
  // A - B = 1 + t over 2..4 s: mean 4, largest 5 at 4 s; the rates are 1 deg/s apart.
  const Json json = json::parse(outcome.out);
  EXPECT_NEAR(json["mean_abs_angle_difference_deg"].number(), 4.0, 1e-5);
  EXPECT_NEAR(json["max_abs_angle_difference_deg"].number(), 5.0, 1e-5);
  EXPECT_NEAR(json["mean_abs_rate_difference_deg_s"].number(), 1.0, 1e-5);
  const std::string page = content(folder / "out/report/a_and_b/report.html");
  expect_said(page, {"Speed"});
  EXPECT_EQ(page.find("Roll command"), std::string::npos) << "neither log has one";
  EXPECT_EQ(page.find("src="), std::string::npos);
}

TEST(Report, ALogAndATableCanBeLaidOverEachOther) {
  const Folder folder;
  folder.write("flown.ftl", made_log());
  ASSERT_EQ(
      fantail({"log", "export", "flown.ftl", "--to", "csv", "--out", "same.csv"}, {.working_folder = folder.path()})
          .exit_code,
      0);
  const Outcome outcome = run_in(folder, {"report", "flown.ftl", "same.csv", "--json"});
  EXPECT_EQ(json::parse(outcome.out)["max_abs_angle_difference_deg"], 0.0);
}

TEST(Report, RefusesWithTheReasonAndWithoutAFile) {
  Refusal({}, {"report"}, 64, {"A"});
  Refusal({}, {"report", "nowhere.ftl"}, 66, {"nowhere.ftl"});
  Refusal({}, {"report", "nowhere.csv"}, 66, {"nowhere.csv"});
  Refusal({{"folder/other", ""}}, {"report", "folder"}, 66,
          {"folder: this folder contains no flight.csv or flight.ftl"});
  Refusal({{"a.csv", "t,b\n0,1\n"}}, {"report", "a.csv"}, 65, {"a.csv", "time_s"});
  Refusal({{"a.csv", line(0, 1)}}, {"report", "a.csv", "--align", "angle"}, 64, {"--align"});
  Refusal({{"a.ftl", "not a log"}}, {"report", "a.ftl"}, 65, {"a.ftl", "contains no record of a flight"});
}

}  // namespace
}  // namespace fantail::test
