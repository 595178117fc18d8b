// SPDX-License-Identifier: MIT
#include "logs/roll_log.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "degree.hpp"
#include "logs/refused.hpp"
#include "system/folder.hpp"
#include "text/error.hpp"

namespace fantail::logs {
namespace {

using test::expect_refused;
using text::ErrorKind;

const std::string head = "time_s,roll_angle_deg,roll_rate_deg_s,canard_deg,speed_m_s\n";

files::Sources named(const std::string& text) { return files::parse_columns(text, "--columns", files::of_flight_csv); }

class RollLogFile : public testing::Test {
 protected:
  RollLog read(const std::string& text, const Reading& reading = {},
               const Needs& needs = {.canard = true, .speed = true}) {
    return read_roll_log(folder_.write("log.csv", text), reading, needs);
  }
  void expect_bad(const std::string& text, std::initializer_list<const char*> words, const Reading& reading = {},
                  const Needs& needs = {.canard = true, .speed = true}) {
    expect_refused(ErrorKind::bad_data, words, [&] { (void)read(text, reading, needs); });
  }

  const test::Folder folder_;
};

std::string rows(std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += std::to_string(i) + "e-2,1,0,5,22\n";
  }
  return text;
}

TEST_F(RollLogFile, IsReadInRadians) {
  const RollLog log = read(head + "-0.5,10,180,-6,20\n0.25,20,-90,9,21.5\n");
  EXPECT_EQ(log.time_s, (std::vector{-0.5, 0.25}));
  EXPECT_DOUBLE_EQ(log.roll_angle_rad[1], 20.0 * degree);
  EXPECT_DOUBLE_EQ(log.roll_rate_rad_s[0], std::numbers::pi);
  EXPECT_DOUBLE_EQ(log.canard_rad[0], -6.0 * degree);
  EXPECT_EQ(log.speed_m_s, (std::vector{20.0, 21.5}));
  EXPECT_TRUE(log.height_m.empty());
  EXPECT_TRUE(log.phase.empty());
}

TEST_F(RollLogFile, HasEveryColumnThatFantailKnows) {
  const RollLog log = read(
      "height_m,phase,time_s,roll_angle_deg,roll_rate_deg_s,canard_deg,speed_m_s,command_deg,reference_deg,"
      "excitation_deg,specific_force_m_s2,other\n"
      "7,launched,0,1,2,3,4,5,6,-7,9.5,\n8,controlling,1,1,2,3,4,5,6,-7,9.5,text\n");
  EXPECT_EQ(log.height_m, (std::vector{7.0, 8.0}));
  EXPECT_EQ(log.phase, (std::vector{core::Phase::launched, core::Phase::controlling}));
  EXPECT_DOUBLE_EQ(log.command_rad[0], 5.0 * degree);
  EXPECT_DOUBLE_EQ(log.reference_rad[0], 6.0 * degree);
  EXPECT_DOUBLE_EQ(log.excitation_rad[0], -7.0 * degree);
  EXPECT_EQ(log.specific_force_m_s2[1], 9.5);
}

TEST_F(RollLogFile, AColumnThatIsMissingIsNamedAndTheOthersListed) {
  expect_bad("time_s,roll_angle,roll_rate_deg_s,canard_deg,speed_m_s\n" + rows(3),
             {"log.csv: no column roll_angle_deg", "did you mean roll_angle?",
              "the columns are: time_s, roll_angle, roll_rate_deg_s, canard_deg, speed_m_s",
              "--columns roll_angle=NAME:UNIT"});
  expect_bad("time,roll_angle_deg\n1,2\n", {"no column time_s", "did you mean time?"});
  expect_bad("time_s,roll_angle_deg,roll_rate_deg_s,canard_deg\n1,2,3,4\n", {"no column speed_m_s", "--speed"});
  EXPECT_NO_THROW((void)read("time_s,roll_angle_deg\n0,1\n1,2\n", {}, {.roll_rate = false}));
}

TEST_F(RollLogFile, ColumnsMayHaveOtherNames) {
  const Reading reading{.columns = named("roll_angle_deg=phi,time_s=t")};
  const std::string text = "t,phi,roll_rate_deg_s,canard_deg,speed_m_s\n0,90,0,0,1\n1,0,0,0,1\n";
  EXPECT_DOUBLE_EQ(read(text, reading).roll_angle_rad[0], std::numbers::pi / 2.0);
  expect_bad(head + rows(3), {"no column t"}, reading);
  expect_bad(head + rows(3), {"no column psi", "the columns are"}, {.columns = named("phase=psi")});
}

TEST_F(RollLogFile, AnglesMayBeInRadians) {
  const Reading reading{.angles = AngleUnit::radians};
  EXPECT_EQ(read(head + "0,1,2,0.1,4\n1,1,2,0.2,4\n", reading).roll_angle_rad[0], 1.0);
  const RollLog log =
      read("time_s,roll_angle_rad,roll_rate_rad_s,canard_rad,speed_m_s\n0,1,2,0.1,4\n1,1,2,0.2,4\n", reading);
  EXPECT_EQ(log.roll_rate_rad_s[0], 2.0);
  EXPECT_EQ(log.canard_rad[1], 0.2);
}

TEST_F(RollLogFile, OfASimulatedFlightMayBeTheTruth) {
  const std::string text =
      "time_s,roll_angle_deg,true_roll_angle_deg,roll_rate_deg_s,true_roll_rate_deg_s,canard_deg,true_canard_deg,"
      "speed_m_s,true_speed_m_s\n0,1,2,3,4,5,6,0,22\n1,1,2,3,4,5,6,0,22\n";
  const RollLog log = read(text, {.truth = true});
  EXPECT_DOUBLE_EQ(log.roll_angle_rad[0], 2.0 * degree);
  EXPECT_DOUBLE_EQ(log.roll_rate_rad_s[0], 4.0 * degree);
  EXPECT_DOUBLE_EQ(log.canard_rad[0], 6.0 * degree);
  EXPECT_EQ(log.speed_m_s[0], 22.0);
  EXPECT_EQ(log.estimated_speed_m_s[0], 0.0) << "the flight law went by it";
  expect_bad(head + rows(3), {"no column true_roll_angle_deg", "did you mean roll_angle_deg?"}, {.truth = true});
}

TEST_F(RollLogFile, AFewRowsWithoutNumbersAreLeftOutAndCounted) {
  const RollLog log = read(head + rows(100) + "1,nan,0,5,22\n1.5,1,0,5,22\n");
  EXPECT_EQ(log.time_s.size(), 101U);
  ASSERT_EQ(log.warnings.size(), 1U);
  EXPECT_NE(log.warnings[0].find("1 of 102 rows have no number in a required column (first: line 102, roll_angle_deg "
                                 "\"nan\"); they are left out"),
            std::string::npos)
      << log.warnings[0];
}

TEST_F(RollLogFile, CellsThatNobodyNeedsMayBeEmpty) {
  const std::string text =
      "time_s,roll_angle_deg,roll_rate_deg_s,canard_deg,reference_deg\n0,1,2,,\n1,1,2,6,\n2,1,2,,\n";
  const RollLog log = read(text, {}, {});
  ASSERT_EQ(log.canard_rad.size(), 3U);
  EXPECT_TRUE(std::isnan(log.canard_rad[0]));
  EXPECT_DOUBLE_EQ(log.canard_rad[1], 6.0 * degree);
  EXPECT_TRUE(log.reference_rad.empty()) << "a column without a single number is none";
}

TEST_F(RollLogFile, APhaseThatIsNoneIsNotUsed) {
  const RollLog log =
      read("time_s,phase,roll_angle_deg,roll_rate_deg_s\n0,armed,1,2\n1,boost,1,2\n2,armed,1,2\n", {}, {});
  EXPECT_TRUE(log.phase.empty());
  ASSERT_EQ(log.warnings.size(), 2U);
  EXPECT_NE(log.warnings[0].find("log.csv:3: \"boost\""), std::string::npos) << log.warnings[0];
}

TEST_F(RollLogFile, AnAngleThatIsWrappedIntoOneTurnIsContinued) {
  // 100 deg/s from 170 deg on, written between -180 and 180 and then back.
  std::string text = "time_s,roll_angle_deg,roll_rate_deg_s\n";
  for (int i = 0; i <= 1000; ++i) {
    const double t = i * 0.01;
    const double angle = i <= 500 ? 170.0 + 100.0 * t : 670.0 - 100.0 * (t - 5.0);
    text += std::to_string(t) + "," + std::to_string(std::remainder(angle, 360.0)) + (i <= 500 ? ",100\n" : ",-100\n");
  }
  const RollLog log = read(text, {}, {});
  EXPECT_NEAR(log.roll_angle_rad[500], 670.0 * degree, 1e-6);
  EXPECT_NEAR(log.roll_angle_rad[1000], 170.0 * degree, 1e-6);
  ASSERT_EQ(log.warnings.size(), 1U);
  EXPECT_NE(log.warnings[0].find("whole turn 4 times"), std::string::npos) << log.warnings[0];
}

TEST_F(RollLogFile, TooFewRowsAreRefused) {
  expect_bad(head, {"log.csv: no rows after the header"});
  expect_bad(head + rows(1), {"log.csv: fewer than two rows"});
}

TEST_F(RollLogFile, AFlightFolderKnowsWhenTheMotorBurntOut) {
  folder_.write("flight/flight.csv", head + rows(3));
  folder_.write("flight/summary.json", R"({"events": {"burnout_s": 3.188, "apogee_s": null}})");
  const RollLog log = read_roll_log(folder_.path() / "flight", {}, {});
  EXPECT_EQ(log.name, folder_ / "flight");
  EXPECT_EQ(log.burnout_s, 3.188);
  EXPECT_EQ(log.apogee_s, std::nullopt);
}

TEST_F(RollLogFile, AFolderMayLackASummaryButNotAFlight) {
  folder_.write("flight/flight.csv", head + rows(3));
  EXPECT_EQ(read_roll_log(folder_.path() / "flight", {}, {}).burnout_s, std::nullopt);
  folder_.write("broken/flight.csv", head + rows(3));
  folder_.write("broken/summary.json", "{\"events\": ");
  expect_refused(ErrorKind::bad_data, {"summary.json: is not the summary of a flight"},
                 [&] { (void)read_roll_log(folder_.path() / "broken", {}, {}); });
  folder_.write("empty/other.txt", "");
  expect_refused(ErrorKind::no_such_input, {"empty: this folder contains no flight.csv"},
                 [&] { (void)read_roll_log(folder_.path() / "empty", {}, {}); });
  expect_refused(ErrorKind::no_such_input, {"gone.csv: no such file"},
                 [&] { (void)read_roll_log(folder_.path() / "gone.csv", {}, {}); });
}

}  // namespace
}  // namespace fantail::logs
