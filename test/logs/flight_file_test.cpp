// SPDX-License-Identifier: MIT
#include "logs/flight_file.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "flight_log/made_flight.hpp"
#include "logs/refused.hpp"
#include "logs/roll_log.hpp"
#include "system/folder.hpp"
#include "text/sha256.hpp"

namespace fantail::logs {
namespace {

using flight_log::MadeFlight;
using test::expect_refused;
using text::ErrorKind;

class FlightFile : public testing::Test {
 protected:
  [[nodiscard]] std::string log_with_damage() const {
    // A hundred records from the middle of the first second.
    std::vector<std::byte> bytes = made_.bytes;
    const auto begin = static_cast<std::ptrdiff_t>(made_.frame_ends[200]);
    std::fill(bytes.begin() + begin, bytes.begin() + static_cast<std::ptrdiff_t>(made_.frame_ends[300]), std::byte{0});
    return test::as_text(bytes);
  }

  const MadeFlight made_ = flight_log::make_flight();
  const test::Folder folder_;
};

TEST_F(FlightFile, AFlightLogGivesTheRollMotionOfItsReplay) {
  const RollLog log = read_roll_log(folder_.write("flown.ftl", test::as_text(made_.bytes)), {}, {});
  ASSERT_EQ(log.time_s.size(), made_.records.size());
  EXPECT_TRUE(log.warnings.empty());
  for (std::size_t i = 0; i < log.time_s.size(); ++i) {
    const core::TickRecord& record = made_.records[i];
    ASSERT_EQ(log.roll_angle_rad[i], static_cast<double>(record.motion.roll_angle.radians()));
    ASSERT_EQ(log.roll_rate_rad_s[i], static_cast<double>(record.motion.roll_rate_rad_s));
    ASSERT_EQ(log.phase[i], record.phase);
    ASSERT_NEAR(log.time_s[i] - log.time_s[0],
                1e-6 * static_cast<double>((record.time - made_.records[0].time).count()), 1e-9);
  }
}

TEST_F(FlightFile, OfAFolderTheTableIsTakenAndWithoutOneTheLog) {
  folder_.write("only/flight.ftl", test::as_text(made_.bytes));
  EXPECT_EQ(read_roll_log(folder_.path() / "only", {}, {}).time_s.size(), made_.records.size());
  folder_.write("both/flight.ftl", test::as_text(made_.bytes));
  folder_.write("both/flight.csv", "time_s,roll_angle_deg,roll_rate_deg_s\n0,0,0\n1,0,0\n");
  EXPECT_EQ(read_roll_log(folder_.path() / "both", {}, {}).time_s.size(), 2U);
}

TEST_F(FlightFile, ThePlanThatFlewIsInTheLogOrInTheOneBesideTheTable) {
  const auto kp = [](const std::filesystem::path& path) {
    const std::optional<core::FlightPlan> plan = flown_plan(path, {});
    return plan ? std::optional{plan->controller.proportional_gain} : std::nullopt;
  };
  const std::optional<float> flown = made_.plan.controller.proportional_gain;
  const std::filesystem::path log = folder_.write("both/flight.ftl", test::as_text(made_.bytes));
  const std::filesystem::path table = folder_.write("both/flight.csv", "time_s,roll_angle_deg\n0,1\n");
  EXPECT_EQ(kp(log), flown);
  EXPECT_EQ(kp(table), flown);
  EXPECT_EQ(kp(table.parent_path()), flown);
  EXPECT_EQ(kp(folder_.write("both/other.csv", "time_s\n")), std::nullopt);
  EXPECT_EQ(kp(folder_.write("alone/flight.csv", "time_s\n")), std::nullopt);
}

TEST_F(FlightFile, WhatIsLostIsAGapInTimeAndAWarning) {
  const RollLog log = read_roll_log(folder_.write("torn.ftl", log_with_damage()), {}, {});
  double longest_s = 0.0;
  for (std::size_t i = 1; i < log.time_s.size(); ++i) {
    longest_s = std::max(longest_s, log.time_s[i] - log.time_s[i - 1]);
  }
  EXPECT_GT(longest_s, 0.09);  // and on to the next state to replay from
  EXPECT_LT(log.time_s.size(), made_.records.size() - 90);
  ASSERT_FALSE(log.warnings.empty());
  EXPECT_NE(log.warnings[0].find("100 records lost in 1 gap"), std::string::npos) << log.warnings[0];
}

TEST_F(FlightFile, WhatOnlyATableCanBeAskedIsRefusedOfALog) {
  const auto path = folder_.write("flown.ftl", test::as_text(made_.bytes));
  expect_refused(ErrorKind::bad_configuration, {"flown.ftl: this is a flight log", "not true values"},
                 [&] { (void)read_roll_log(path, {.truth = true}, {}); });
  expect_refused(ErrorKind::bad_configuration, {"flown.ftl: this is a flight log", "angle unit is fixed"},
                 [&] { (void)read_roll_log(path, {.angles = AngleUnit::radians}, {}); });
  expect_refused(ErrorKind::bad_configuration, {"flown.ftl: this is a flight log", "its column names are fixed"}, [&] {
    (void)read_roll_log(path, {.columns = files::parse_columns("roll_angle_deg=phi", "x", files::of_flight_csv)}, {});
  });
}

TEST_F(FlightFile, OfSeveralFlightsNoneIsTakenAtRandom) {
  flight_log::MadeFlightOptions second;
  second.flight = 2;
  const auto path =
      folder_.write("two.ftl", test::as_text(made_.bytes) + test::as_text(flight_log::make_flight(second).bytes));
  expect_refused(ErrorKind::bad_data, {"two.ftl: contains 2 flights", "fantail log export", "--flight"},
                 [&] { (void)read_flight(path); });
}

TEST_F(FlightFile, AFlightThatCannotBeReplayedSaysWhy) {
  // Without its header nobody knows the plan: from the first record on to the last but one thousand.
  const std::string bytes = test::as_text(made_.bytes);
  const auto path = folder_.write("tail.ftl", bytes.substr(made_.frame_ends[made_.frame_ends.size() - 100]));
  expect_refused(ErrorKind::bad_data, {"tail.ftl: the flight cannot be replayed"}, [&] { (void)read_flight(path); });
}

TEST_F(FlightFile, AFolderWhoseSummaryNamesNoScenarioIsCalledByItsOwnName) {
  folder_.write("flown/flight.csv", "time_s,roll_angle_deg,roll_rate_deg_s\n0,1,2\n1,3,2\n");
  EXPECT_EQ(read_flight(folder_.path() / "flown/").scenario, "flown");
  folder_.write("flown/summary.json", R"({"vehicle":"v"})");
  EXPECT_EQ(read_flight(folder_.path() / "flown").scenario, "flown");
}

TEST_F(FlightFile, OfAFolderRowsComeFromTheTableReasonsFromTheSummaryAndThePlanFromTheLog) {
  folder_.write("flown/flight.ftl", test::as_text(made_.bytes));
  folder_.write("flown/flight.csv",
                "time_s,phase,roll_angle_deg,true_roll_angle_deg\n0,armed,1,2\n1,launched,1,2\n2,controlling,,4\n");
  folder_.write("flown/summary.json",
                R"({"scenario":"s","vehicle":"v","plan":"p","seed":5,"version":"1","events":{"apogee_s":1.5},)"
                R"("phase_changes":[{"time_s":1,"phase":"launched","reason":"launch_detected"}],)"
                R"("canard_verdicts":[{"time_s":1.5,"canard":4,"verdict":"dead"}],)"
                R"("imposed_roll":{"time_s":1,"angle_deg":180,"rate_deg_s":0},"notes":["A note."]})");
  const flight::Flight flight = read_flight(folder_.path() / "flown");
  EXPECT_EQ(flight.rows.size(), 3U);
  EXPECT_TRUE(flight.rows[0].truth);
  EXPECT_TRUE(flight.known.plan);
  EXPECT_EQ(flight.plan.controller.canard_limit, made_.plan.controller.canard_limit);
  EXPECT_EQ(flight.seed, 5U);
  EXPECT_EQ(flight.events.apogee_s, 1.5);
  EXPECT_EQ(flight.events.control_start_s, 2.0);
  ASSERT_EQ(flight.phase_changes.size(), 1U);
  EXPECT_EQ(flight.phase_changes[0].reason, core::PhaseReason::launch_detected);
  ASSERT_EQ(flight.canard_verdict_changes.size(), 1U);
  EXPECT_EQ(flight.canard_verdict_changes[0].canard, 3U);
  EXPECT_NEAR(flight.imposed_roll.value().angle_rad, 3.14159265358979, 1e-12);
  EXPECT_EQ(flight.notes, std::vector<std::string>{"A note."});
}

TEST_F(FlightFile, FilesOfTwoFlightsInOneFolderAreRefused) {
  folder_.write("mixed/flight.csv",
                "time_s,phase,roll_angle_deg,roll_rate_deg_s\n0,launched,1,0\n1,controlling,1,0\n2,controlling,3,0\n");
  folder_.write("mixed/summary.json", R"({"events":{"control_start_s":0.6}})");
  EXPECT_EQ(read_flight(folder_.path() / "mixed").events.control_start_s, 0.6);  // between two rows
  folder_.write("mixed/summary.json", R"({"events":{"control_start_s":1.3}})");
  const auto refused = [&](std::initializer_list<const char*> words) {
    expect_refused(ErrorKind::bad_data, words, [&] { (void)read_flight(folder_.path() / "mixed"); });
    expect_refused(ErrorKind::bad_data, words, [&] { (void)read_roll_log(folder_.path() / "mixed", {}, {}); });
  };
  refused({"mixed: its files are of two flights", "come under control at 1.000 s", "but at 1.300 s in summary.json"});
  folder_.write("mixed/flight.csv",
                "time_s,phase,roll_angle_deg,roll_rate_deg_s\n0,launched,1,0\n1,controlling,1,0\n2,controlling,3,0\n"
                "3,finished,3,0\n");
  const auto control = [&](const char* said) {
    folder_.write("mixed/summary.json",
                  R"({"events":{"control_start_s":1,"control_end_s":3)" + std::string{said} + "}");
  };
  control(R"(},"control_time_s":1,"roll_turns":0.0056)");
  EXPECT_EQ(read_flight(folder_.path() / "mixed").rows.size(), 4U);
  control(R"(},"control_time_s":1,"roll_turns":0.5)");
  refused({"mixed: its files are of two flights", "makes 0.006 turns in flight.csv, but 0.500 in"});
  control(R"(},"control_time_s":1.5,"roll_turns":0.5)");  // of more rows
  EXPECT_EQ(read_flight(folder_.path() / "mixed").rows.size(), 4U);
  folder_.write("mixed/summary.json", R"({"events":{"control_start_s":1,"control_end_s":2.0}})");
  EXPECT_EQ(read_flight(folder_.path() / "mixed").rows.size(), 4U);
  folder_.write("mixed/summary.json", R"({"events":{"control_start_s":1,"control_end_s":1.9}})");
  refused({"mixed: its files are of two flights", "leave control at 3.000 s", "but at 1.900 s in summary.json"});
  folder_.write("mixed/flight.ftl", test::as_text(made_.bytes));
  const auto summary = [&](const std::string& sha256) {
    folder_.write("mixed/summary.json", R"({"log_sha256":")" + sha256 + R"("})");
  };
  summary(std::string(64, '0'));
  expect_refused(ErrorKind::bad_data, {"mixed: its files are of two flights: flight.ftl does not have the SHA-256"},
                 [&] { (void)read_flight(folder_.path() / "mixed"); });
  expect_refused(ErrorKind::bad_data, {"mixed: its files are of two flights"},
                 [&] { (void)flown_plan(folder_.path() / "mixed/flight.csv", {}); });
  summary(text::sha256(made_.bytes));
  EXPECT_TRUE(read_flight(folder_.path() / "mixed").known.plan);
}

// Whoever takes something from beside a file takes it from a file of the same flight.
TEST_F(FlightFile, TheSummaryOfAnotherFlightSaysNothingOfALog) {
  constexpr const char* rocket =
      R"("vehicle":"v","vehicle_file":"v","roll_inertia_kg_m2":0.004,"reference_area_m2":5e-5})";
  const auto summary = [&](const std::string& sha256) {
    folder_.write("day/summary.json", R"({"log_sha256":")" + sha256 + R"(",)" + rocket);
  };
  const std::filesystem::path log = folder_.write("day/flight.ftl", test::as_text(made_.bytes));
  const std::filesystem::path day = log.parent_path();
  summary(text::sha256(made_.bytes));
  for (const std::filesystem::path& path : {log, day}) {
    EXPECT_EQ(flown_airframe(path, {}).value().roll_inertia_kg_m2, 0.004);
    EXPECT_EQ(read_roll_log(path, {}, {}).time_s.size(), made_.records.size());
  }
  summary(std::string(64, '0'));
  const std::initializer_list<const char*> words{
      "day: its files are of two flights: flight.ftl does not have the SHA-256"};
  for (const std::filesystem::path& path : {log, day}) {
    expect_refused(ErrorKind::bad_data, words, [&] { (void)flown_airframe(path, {}); });
  }
  expect_refused(ErrorKind::bad_data, words, [&] { (void)read_roll_log(day, {}, {}); });
  expect_refused(ErrorKind::bad_data, words, [&] { (void)read_flight(day); });
  EXPECT_EQ(read_roll_log(log, {}, {}).time_s.size(), made_.records.size());  // takes nothing from beside it
  EXPECT_EQ(read_flight(log).rows.size(), made_.records.size());
  const std::filesystem::path table =
      folder_.write("day/flight.csv", "time_s,roll_angle_deg,roll_rate_deg_s\n0,0,0\n1,0,0\n");
  expect_refused(ErrorKind::bad_data, words, [&] { (void)read_roll_log(day, {}, {}); });
  expect_refused(ErrorKind::bad_data, words, [&] { (void)flown_airframe(table, {}); });
  expect_refused(ErrorKind::bad_data, words, [&] { (void)flown_plan(table, {}); });
  EXPECT_EQ(read_roll_log(table, {}, {}).time_s.size(), 2U);
}

TEST_F(FlightFile, NorDoesThatOfAnotherTableThanTheOneThatIsNamed) {
  const std::filesystem::path table =
      folder_.write("day/flight.csv", "t,phase,roll_angle_deg,roll_rate_deg_s\n0,launched,1,0\n1,controlling,1,0\n");
  const auto airframe = [&](const char* control_start_s) {
    folder_.write("day/summary.json", R"({"roll_inertia_kg_m2":0.004,"reference_area_m2":5e-5,)"
                                      R"("events":{"control_start_s":)" +
                                          std::string{control_start_s} + "}}");
    return flown_airframe(table, {.columns = files::parse_columns("time_s=t", "x", files::of_flight_csv)});
  };
  EXPECT_EQ(airframe("0.5").value().reference_area_m2, 5e-5);
  expect_refused(ErrorKind::bad_data, {"day: its files are of two flights", "under control at 1.000 s"},
                 [&] { (void)airframe("1.5"); });
}

TEST_F(FlightFile, ASummaryThatIsNoneIsRefused) {
  folder_.write("flown/flight.csv", "time_s,roll_angle_deg\n0,1\n");
  folder_.write("flown/summary.json", "[1, 2");
  expect_refused(ErrorKind::bad_data, {"summary.json: is not the summary of a flight"},
                 [&] { (void)read_flight(folder_.path() / "flown"); });
}

}  // namespace
}  // namespace fantail::logs
