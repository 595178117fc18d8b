// SPDX-License-Identifier: MIT
#include <fstream>

#include "flight_log/flight_log.hpp"
#include "flight_log/made_flight.hpp"
#include "flight_log/regenerate.hpp"
#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "system/refusal.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

using Json = json::Value;

std::string made_log() {
  static const std::string log = test::as_text(flight_log::make_flight().bytes);
  return log;
}

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream{path, std::ios::binary}.rdbuf();
  return text.str();
}

std::size_t lines(const std::string& text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

class LogExport : public testing::Test {
 protected:
  LogExport() { folder_.write("flown.ftl", made_log()); }

  Outcome run(const Words& more) const {
    Words words{"log", "export", "flown.ftl"};
    words.insert(words.end(), more.begin(), more.end());
    return fantail(words, {.working_folder = folder_.path()});
  }

  const Folder folder_;
};

TEST_F(LogExport, WritesEachFormatUnderTheNameOfTheLogAndSaysWhere) {
  for (const char* format : {"csv", "mat", "parquet", "mcap", "ulog", "lcm", "candump", "json"}) {
    const Outcome outcome = run({"--to", format});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    ASSERT_FALSE(outcome.out.empty());
    EXPECT_TRUE(outcome.out.starts_with("out/export/flown.")) << outcome.out;
    EXPECT_FALSE(content(folder_ / outcome.out.substr(0, outcome.out.size() - 1)).empty()) << format;
  }
}

TEST_F(LogExport, PutsTheUnitsOfATableAndTheTypesOfLcmBesideIt) {
  run({"--to", "csv", "--out", "tables/own.csv", "--fields", "time_us,rate_x_count"});
  const Json columns = json::parse(content(folder_ / "tables/own.columns.json"));
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_EQ(columns[0]["column"], "time_us");
  EXPECT_EQ(columns[0]["unit"], "us");
  EXPECT_EQ(columns[1]["column"], "rate_x_count");
  EXPECT_EQ(columns[1]["unit"], "count");

  run({"--to", "lcm", "--out", "messages/flown.lcmlog"});
  for (const char* type : {"state_t", "canards_t", "event_t", "health_t"}) {
    const std::string file = std::string{type} + ".lcm";
    EXPECT_EQ(content(folder_ / ("messages/" + file)), content(FANTAIL_TEST_SOURCE "/tools/telemetry/types/" + file))
        << file;
  }
}

// The true columns of a simulated flight are in no log.
TEST_F(LogExport, LeavesWhatAFlightPutBesideItsLog) {
  folder_.write("flight/flight.ftl", made_log());
  folder_.write("flight/flight.csv", "the truth");
  folder_.write("flight/summary.json", "{}");
  for (const char* file : {"flight.ftl", "flight.csv", "summary.json"}) {
    const Outcome outcome = fantail({"log", "export", "flight", "--to", "csv", "--out", std::string{"flight/"} + file},
                                    {.working_folder = folder_.path()});
    EXPECT_EQ(outcome.exit_code, 74) << outcome.err;
  }
  EXPECT_EQ(content(folder_ / "flight/flight.csv"), "the truth");
  EXPECT_EQ(
      fantail({"log", "export", "flight", "--to", "csv", "--out", "flight/own.csv"}, {.working_folder = folder_.path()})
          .exit_code,
      0);
}

TEST_F(LogExport, ReplacesNothingButAnEarlierExportInAnyFolder) {
  folder_.write("a/flight.ftl", made_log());
  folder_.write("b/flight.ftl", "another flight");
  folder_.write("b/flight.csv", "its truth");
  folder_.write("b/summary.json", "{}");
  folder_.write("mine.toml", "a scenario");
  const auto exported = [&](const char* format, const std::string& out) {
    return fantail({"log", "export", "a", "--to", format, "--out", out}, {.working_folder = folder_.path()}).exit_code;
  };
  EXPECT_EQ(exported("csv", "b/flight.ftl"), 74);
  EXPECT_EQ(exported("csv", "b/flight.csv"), 74);
  EXPECT_EQ(exported("json", "b/summary.json"), 74);
  EXPECT_EQ(exported("candump", "mine.toml"), 74);
  EXPECT_EQ(content(folder_ / "b/flight.ftl"), "another flight");
  EXPECT_EQ(content(folder_ / "b/flight.csv"), "its truth");
  EXPECT_EQ(content(folder_ / "mine.toml"), "a scenario");
  EXPECT_EQ(exported("csv", "a/own.csv"), 0);
  EXPECT_EQ(exported("csv", "a/own.csv"), 0);
}

TEST_F(LogExport, TheSameLogGivesTheSameBytes) {
  for (const char* format : {"csv", "mat", "parquet", "mcap", "ulog", "lcm", "candump", "json"}) {
    EXPECT_EQ(run({"--to", format, "--out", "-"}).out, run({"--to", format, "--out", "-"}).out) << format;
  }
}

TEST_F(LogExport, AsATableIsTheSameMotionToWhatReadsLogs) {
  for (const char* ending : {"mat", "parquet"}) {
    ASSERT_EQ(run({"--to", ending}).exit_code, 0);
    const Outcome outcome = fantail({"compare", "flown.ftl", std::string{"out/export/flown."} + ending, "--json"},
                                    {.working_folder = folder_.path()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json json = json::parse(outcome.out);
    EXPECT_NEAR(json["max_abs_angle_difference_deg"].number(), 0.0, 1e-9) << ending;
    EXPECT_NEAR(json["max_abs_rate_difference_deg_s"].number(), 0.0, 1e-9) << ending;
  }
}

TEST_F(LogExport, GoesToStandardOutputWholeAndAlone) {
  const Outcome outcome = run({"--to", "csv", "--out", "-", "--fields", "time_us,rate_x_count"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  // Three seconds of ticks; the counts of the made-up gyro are 1 on the pad and 500 in flight.
  EXPECT_EQ(lines(outcome.out), 3001U);
  EXPECT_TRUE(outcome.out.starts_with("time_us,rate_x_count\n5500000,1\n")) << outcome.out.substr(0, 80);
  EXPECT_TRUE(outcome.out.ends_with("8499000,500\n"));
  EXPECT_EQ(folder_.listing(), Words{"flown.ftl"});
}

TEST_F(LogExport, CutsOutAStretchWithBothEnds) {
  const Words times{"--to", "json", "--out", "-", "--fields", "time_s"};
  const Json all = json::parse(run(times).out)["ticks"]["time_s"];
  ASSERT_EQ(all.size(), 3000U);
  Words stretch = times;
  stretch.insert(stretch.end(), {"--from", all[1000].dump(), "--until", all[1250].dump()});
  const Outcome outcome = run(stretch);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["ticks"]["time_s"],
            Json(std::vector<Json>(all.begin() + 1000, all.begin() + 1251)));
}

TEST_F(LogExport, WhatIsLostIsSaidOnStandardErrorAndTheRestIsExported) {
  const flight_log::MadeFlight made = flight_log::make_flight();
  std::string torn = made_log();
  torn.replace(made.frame_ends[200], made.frame_ends[300] - made.frame_ends[200],
               made.frame_ends[300] - made.frame_ends[200], '\0');
  folder_.write("flown.ftl", torn);
  const Outcome outcome = run({"--to", "csv"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("fantail: note: The log is damaged: 100 records lost in 1 gap"), std::string::npos)
      << outcome.err;
  EXPECT_GT(lines(content(folder_ / "out/export/flown.csv")), 2000U);
}

// How many ticks are left is counted by the reader alone; the rows that are marked are those to which no replay leads.
TEST_F(LogExport, EveryTickThatIsLeftOfADamagedLogHasItsRow) {
  const std::string whole = made_log();
  constexpr std::size_t sector = 4096;
  std::string flipped = whole;
  for (std::size_t at = whole.size() / 3; at < whole.size(); at += whole.size() / 7) {
    flipped[at] = static_cast<char>(flipped[at] ^ 0x10);
  }
  std::string lost_sector = whole;
  lost_sector.replace(whole.size() / 2 / sector * sector, sector, sector, '\xFF');
  for (const std::string& log : {flipped, lost_sector}) {
    const flight_log::LogFile file = flight_log::parse_log(std::as_bytes(std::span{log}), "flown.ftl");
    ASSERT_EQ(file.flights.size(), 1U);
    const flight_log::Flight& flight = file.flights[0];
    const auto replay = flight_log::regenerate(flight, flight.plan.value());
    ASSERT_GT(replay.unreachable, 0U);
    ASSERT_LT(flight.ticks.size(), 3000U);
    folder_.write("flown.ftl", log);
    const Outcome outcome = run({"--to", "csv", "--out", "-"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(lines(outcome.out), 1 + flight.ticks.size());
    std::size_t marked = 0;
    for (std::size_t at = outcome.out.find(",0\n"); at != std::string::npos; at = outcome.out.find(",0\n", at + 1)) {
      marked += 1;
    }
    EXPECT_EQ(marked, replay.unreachable);
    const Json json = json::parse(run({"--to", "json", "--out", "-", "--fields", "time_us,replayed"}).out);
    EXPECT_EQ(json["ticks"]["time_us"].size(), flight.ticks.size());
    EXPECT_EQ(std::ranges::count(json["ticks"]["replayed"], Json(false)),
              static_cast<std::ptrdiff_t>(replay.unreachable));
    EXPECT_NE(run({"--to", "lcm"}).err.find("--to csv has every tick"), std::string::npos);
  }
}

TEST_F(LogExport, WithoutAReplayTheRecordedFieldsAreStillThere) {
  const flight_log::MadeFlight made = flight_log::make_flight();
  // Header and plan, and then ticks up to the next state to replay from: without that state nothing can be replayed.
  const std::string log = made_log();
  const std::string head = log.substr(0, made.frame_ends[0]);
  const std::string ticks = log.substr(made.frame_ends[1], made.frame_ends[100] - made.frame_ends[1]);
  folder_.write("flown.ftl", head + ticks);
  const Outcome refused = run({"--to", "lcm"});
  EXPECT_EQ(refused.exit_code, 65);
  EXPECT_NE(refused.err.find("The recorded data can be exported with --to csv"), std::string::npos) << refused.err;
  const Outcome rows = run({"--to", "csv", "--out", "-"});
  EXPECT_EQ(rows.exit_code, 0) << rows.err;
  EXPECT_TRUE(rows.out.ends_with(",0\n")) << "marked";
  const Outcome outcome = run({"--to", "csv", "--out", "-", "--fields", "time_us,rate_x_count,roll_angle_deg"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("time_us,rate_x_count,roll_angle_deg\n5500000,1,\n"))
      << outcome.out.substr(0, 80);
}

TEST(LogExportRefuses, WithTheReasonAndWithoutAFile) {
  const std::string log = made_log();
  const auto words = [](const Words& more) {
    Words all{"log", "export", "flown.ftl"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  Refusal({{"flown.ftl", log}}, words({}), 64, {"--to"});
  Refusal({{"flown.ftl", log}}, words({"--to", "xls"}), 64, {"xls", "csv"});
  Refusal({{"flown.ftl", log}}, words({"--to", "csv", "--fields", "time_s,roll_angel_deg"}), 64,
          {"no field \"roll_angel_deg\" (did you mean roll_angle_deg?)", "time_us", "encoder_4_count"});
  Refusal({{"flown.ftl", log}}, words({"--to", "csv", "--fields", "time_s,time_s"}), 64, {"time_s appears twice"});
  Refusal({{"flown.ftl", log}}, words({"--to", "candump", "--fields", "time_s"}), 64, {"fixed messages"});
  Refusal({{"flown.ftl", log}}, words({"--to", "csv", "--from", "2", "--until", "1"}), 64, {"--from 2 is after"});
  Refusal({{"flown.ftl", log}}, words({"--to", "csv", "--from", "nan"}), 64, {"nan"});
  Refusal({{"flown.ftl", log}}, words({"--to", "csv", "--from", "100"}), 65, {"no tick between"});
  Refusal({{"flown.ftl", log}}, words({"--to", "csv", "--flight", "2"}), 64, {"holds one flight; allowed: 1 to 1"});
  Refusal({{"flown.ftl", log + log}}, words({"--to", "csv"}), 64, {"holds 2 flights; which one?"});
  Refusal({{"flown.ftl", "time_s,roll_angle_deg\n0,1\n"}}, words({"--to", "csv"}), 65,
          {"contains no record of a flight"});
  Refusal({}, words({"--to", "csv"}), 66, {"flown.ftl"});
}

}  // namespace
}  // namespace fantail::test
