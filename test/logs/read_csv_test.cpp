// SPDX-License-Identifier: MIT
#include "logs/read_csv.hpp"

#include <fmt/core.h>

#include "core/flight_phase.hpp"
#include "flight/columns.hpp"
#include "flight/write_csv.hpp"
#include "logs/refused.hpp"
#include "report/answer.hpp"
#include "report/figures.hpp"
#include "report/sections.hpp"
#include "report/verdict.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::logs {
namespace {

using flight::Flight;
using flight::Row;
using flight::Table;
using test::expect_refused;
using text::ErrorKind;

constexpr Needs nothing{.roll_angle = false, .roll_rate = false};

Flight read(const std::string& text) { return read_flight_csv(Table::parse(text, "log.csv"), {}, nothing); }

TEST(FlightCsv, ColumnsBecomeRowsInRadiansAndPhasesTheEvents) {
  const Flight flight = read(
      "time_s,phase,roll_angle_deg,command_2_deg,true_roll_angle_deg\n"
      "-0.1,armed,1,2,3\n0,launched,180,,90\n0.5,controlling,0,4,0\n1.1,finished,0,0,0\n");
  ASSERT_EQ(flight.rows.size(), 4U);
  EXPECT_NEAR(flight.rows[1].roll_angle_rad, 3.14159265358979, 1e-12);
  EXPECT_NEAR(flight.rows[1].truth.value().roll_angle_rad, 1.570796326794897, 1e-12);
  EXPECT_FALSE(flight.rows[1].commands_rad[1]);
  EXPECT_NEAR(flight.rows[2].commands_rad[1].value(), text::radians(4.0), 1e-12);
  EXPECT_EQ(flight.events.detected_s, 0.0);
  EXPECT_EQ(flight.events.control_start_s, 0.5);
  EXPECT_EQ(flight.events.control_end_s, 1.1);
  ASSERT_EQ(flight.phase_changes.size(), 4U);
  EXPECT_FALSE(flight.phase_changes[1].reason);
}

TEST(FlightCsv, OfAKnownLoggerNeedsNoNamesAndSaysWhatItIsReadAs) {
  const Flight altimeter = read("T,Alt,Veloc,LDA\n0,0,0,0\n500,100,200,0\n1000,250,300,0\n");
  ASSERT_EQ(altimeter.rows.size(), 3U);
  EXPECT_NEAR(altimeter.rows[1].time_s, 0.5, 1e-12);
  EXPECT_NEAR(altimeter.rows[1].height_m, 30.48, 1e-9);
  EXPECT_NEAR(altimeter.rows[1].speed_m_s, 60.96, 1e-9);
  ASSERT_GE(altimeter.notes.size(), 2U);
  EXPECT_NE(altimeter.notes[0].find("map eggtimer"), std::string::npos) << altimeter.notes[0];
  EXPECT_NE(altimeter.notes[1].find("metres"), std::string::npos) << altimeter.notes[1];
  // One that sits any way round has no known roll rate.
  expect_refused(ErrorKind::bad_data, {"no column"},
                 [] { (void)read("Flight_Time_(s),Accel_X,Accel_Y,Accel_Z,Gyro_X\n0,0,0,-1,5\n0.002,0,0,-1,5\n"); });
}

TEST(FlightCsv, OfAPhaseThatBeganInAHoleNobodyKnowsWhen) {
  std::string text = "time_s,phase,roll_angle_deg\n";
  for (int tick = 0; tick < 1000; ++tick) {
    if (tick < 400 || tick > 600) {
      text += fmt::format("{},{},0\n", 0.001 * tick, tick < 300 ? "launched" : tick < 500 ? "controlling" : "finished");
    }
  }
  const Flight flight = read(text);
  EXPECT_EQ(flight.events.control_start_s, 0.3);
  EXPECT_FALSE(flight.events.control_end_s);
  ASSERT_EQ(flight.phase_changes.size(), 3U);
}

TEST(FlightCsv, RowsThatWereNotReplayedAreLeftOutAndSaidHoweverManyThereAre) {
  const Flight flight = read_flight_csv(
      Table::parse("time_s,phase,roll_angle_deg,replayed\n0,armed,1,1\n0.1,armed,,0\n0.2,armed,,0\n0.3,armed,4,1\n",
                   "log.csv"),
      {}, {.roll_angle = true, .roll_rate = false});
  ASSERT_EQ(flight.rows.size(), 2U);
  EXPECT_EQ(flight.rows[1].time_s, 0.3);
  ASSERT_EQ(flight.notes.size(), 1U);
  EXPECT_EQ(flight.notes[0], "2 of 4 rows belong to ticks that could not be replayed; they are left out.");
}

TEST(FlightCsv, ARowThatWasNotReplayedIsWrittenWithItsMarkAndTheOthersWithTheirs) {
  Flight flight;
  flight.rows = {Row{}, flight::unknown_row()};
  flight.rows[1].time_s = 0.001;
  flight.rows[1].replayed = false;
  const std::string text = flight::csv(flight);
  EXPECT_NE(text.find(",speed_m_s,replayed\n"), std::string::npos) << text;
  EXPECT_EQ(read(text).rows.size(), 1U);
  flight.rows.pop_back();
  EXPECT_EQ(flight::csv(flight).find("replayed"), std::string::npos);
}

std::string joined(const std::vector<std::string>& sentences) {
  std::string all;
  for (const std::string& sentence : sentences) {
    all += sentence + "\n";
  }
  return all;
}

TEST(FlightCsv, ColumnsAreReadInTheUnitsThatAreStatedForThem) {
  const Reading reading{.columns =
                            files::parse_columns("time=t:ms,roll_rate=p:rpm,speed=v:km/h", "x", files::of_flight_csv)};
  const Flight flight =
      read_flight_csv(Table::parse("t,p,v,canard_deg\n1500,60,36,9\n2500,0,72,9\n", "log.csv"), reading, nothing);
  EXPECT_DOUBLE_EQ(flight.rows[0].time_s, 1.5);
  EXPECT_DOUBLE_EQ(flight.rows[0].roll_rate_rad_s, 2.0 * 3.14159265358979323846);
  EXPECT_DOUBLE_EQ(flight.rows[1].speed_m_s, 20.0);
  EXPECT_DOUBLE_EQ(flight.rows[1].canard_rad.value(), text::radians(9.0));
  EXPECT_TRUE(flight.notes.empty()) << joined(flight.notes);
}

TEST(FlightCsv, WhatIsUnusualIsSaid) {
  const Reading reading{.columns = {files::parse_column("roll_rate_deg_s=gyro_x", "x", files::of_flight_csv)}};
  const Flight flight = read_flight_csv(
      Table::parse("time_s,gyro_x,speed_m_s,battery,comment\n0,1,-,7,a\n1,2,22,7,b\n2,3,,7,c\n", "log.csv"), reading,
      nothing);
  const std::string notes = joined(flight.notes);
  for (const char* said :
       {"No unit was stated for gyro_x; it is read in deg/s.", "Columns that are not used: \"battery\", \"comment\".",
        "1 of 3 cells of speed_m_s contain text instead of a number"}) {
    EXPECT_NE(notes.find(said), std::string::npos) << said << "\n" << notes;
  }
  EXPECT_TRUE(std::isnan(flight.rows[2].speed_m_s)) << "an empty cell is usual where a value is not known";
}

TEST(FlightCsv, WhatTheTableDoesNotHaveIsNotKnown) {
  const Flight flight = read("time_s,roll_angle_deg\n0,1\n1,2\n");
  EXPECT_FALSE(flight.known.plan);
  EXPECT_FALSE(flight.known.phase);
  EXPECT_FALSE(flight.known.saturation);
  EXPECT_TRUE(std::isnan(flight.rows[0].speed_m_s));
  EXPECT_FALSE(flight.rows[0].truth);
  EXPECT_TRUE(flight.phase_changes.empty());
  const report::Figures figures = report::figures(flight);
  EXPECT_FALSE(figures.max_speed_m_s);
  EXPECT_FALSE(figures.saturated_fraction);
}

TEST(FlightCsv, APageOfIsMadeWithoutInventingAnything) {
  const Flight flight = read("time_s,roll_angle_deg\n0,1\n1,2\n");
  const report::Figures figures = report::figures(flight);
  const report::Verdict verdict = report::verdict(flight, figures);
  EXPECT_EQ(verdict.outcome, report::Outcome::not_judged);
  const std::string page = result::html(report::answer(flight, figures, verdict));
  for (const char* invented : {"Safe", "canards at their limit", "top speed", "not a number", "seed"}) {
    EXPECT_EQ(page.substr(0, page.find("<script")).find(invented), std::string::npos) << invented;
  }
  EXPECT_NE(page.find("\"title\":\"Roll angle\""), std::string::npos);
  EXPECT_EQ(page.find("\"title\":\"Speed\""), std::string::npos);
}

TEST(FlightCsv, OfATableWithPhasesTheTimeUnderControlIsMeasured) {
  const Flight flight = read(
      "time_s,phase,roll_angle_deg,saturated\n0,armed,0,0\n1,controlling,0,1\n2,controlling,720,0\n3,finished,0,0\n");
  const report::Figures figures = report::figures(flight);
  EXPECT_NEAR(figures.control_time_s.value(), 1.0, 1e-12);
  EXPECT_NEAR(figures.roll_turns.value(), 2.0, 1e-12);
  EXPECT_NEAR(figures.saturated_fraction.value(), 0.5, 1e-12);
  EXPECT_NE(
      report::verdict(flight, figures).text.find("the plan is unknown, and so is the angle where roll should settle"),
      std::string::npos);
}

std::string controlled(std::initializer_list<std::string_view> saturated) {
  std::string text = "time_s,phase,roll_angle_deg,saturated\n0,armed,0,0\n";
  for (const std::string_view cell : saturated) {
    text += fmt::format("{},controlling,0,{}\n", text.size(), cell);
  }
  return text;
}

TEST(FlightCsv, AnOnOffColumnIsReadInTheWordsThatProgramsWriteForIt) {
  const Flight flight = read(controlled({"True", "false", "yes", "No", "TRUE", "1.0", "0.0", "1"}));
  EXPECT_EQ(report::figures(flight).saturated_fraction, 5.0 / 8.0);
  EXPECT_TRUE(flight.notes.empty()) << joined(flight.notes);
}

TEST(FlightCsv, ACellThatIsNeitherOnNorOffLeavesTheShareUnknown) {
  for (const char* cell : {"", "0.4", "-1", "2", "perhaps", "nan"}) {
    const Flight flight = read(controlled({"1", cell, "0"}));
    const report::Figures figures = report::figures(flight);
    EXPECT_FALSE(figures.saturated_fraction) << cell;
    EXPECT_NE(report::verdict(flight, figures).text.find("the log does not say when canards were at their limit"),
              std::string::npos);
    if (*cell != '\0') {
      EXPECT_EQ(
          joined(flight.notes),
          "1 of 4 cells of saturated contain neither 0 nor 1, nor a word for them; they are treated as unknown.\n");
    }
    EXPECT_FALSE(read(flight::csv(flight)).rows[2].saturated);
  }
}

TEST(FlightCsv, ARowThatWasNotReplayedMayBeMarkedByAWord) {
  EXPECT_EQ(read("time_s,roll_angle_deg,replayed\n0,1,True\n1,9,False\n2,9,0.0\n3,4,1\n").rows.size(), 2U);
}

TEST(FlightCsv, ATableOfTwoFlightsIsRefusedWithTheTimeAtWhichItBeginsAnew) {
  const auto refused = [](const char* phases, std::initializer_list<const char*> words) {
    std::string text = "time_s,phase,roll_angle_deg\n";
    double time_s = 0.0;
    for (const char* phase = phases; *phase != '\0'; ++phase, time_s += 0.5) {
      text += fmt::format("{},{},0\n", time_s,
                          core::name(*phase == 's'   ? core::Phase::safe
                                     : *phase == 'a' ? core::Phase::armed
                                     : *phase == 'l' ? core::Phase::launched
                                     : *phase == 'c' ? core::Phase::controlling
                                                     : core::Phase::finished));
    }
    if (words.size() == 0) {
      (void)read(text);
    } else {
      expect_refused(ErrorKind::bad_data, words, [&] { (void)read(text); });
    }
  };
  refused("alccfsalccf",
          {"log.csv: contains more than one flight", "a new one begins at 2.500 s", "safe", "after control"});
  refused("acfcf", {"a new one begins at 1.500 s"});
  refused("acacf", {"a new one begins at 1.000 s"});
  refused("alcfl", {"a new one begins at 2.000 s"});
  refused("alalccf", {});  // detected by mistake
  refused("alcsccf", {});  // resumed after a reset
  refused("alcfsss", {});  // reset after control
  refused("alcsa", {});
}

TEST(FlightCsv, ATableWithoutAFlightIsRefusedWithItsPlace) {
  expect_refused(ErrorKind::bad_data, {"log.csv", "time_s"}, [] { (void)read("t,roll_angle_deg\n0,1\n"); });
  expect_refused(ErrorKind::bad_data, {"log.csv: no column besides time_s is known", "roll_rate_deg_s"},
                 [] { (void)read("time_s,a,b\n0,1,2\n"); });
  expect_refused(ErrorKind::bad_data, {"log.csv:3: time_s is 0 after 1 in line 2: time must increase"},
                 [] { (void)read("time_s,speed_m_s\n1,1\n0,1\n"); });
  expect_refused(ErrorKind::bad_data, {"log.csv: no rows after the header"}, [] { (void)read("time_s,speed_m_s\n"); });
}

TEST(FlightCsv, WhatWasLeftOutOfATableIsANoteOfTheFlight) {
  const Flight flight = read("time_s,phase,speed_m_s\n0,armed,1\n0,armed,1\n1,gliding,1\n");
  ASSERT_EQ(flight.notes.size(), 2U);
  EXPECT_EQ(flight.notes[0], "log.csv:4: \"gliding\" is not a flight phase; the column phase is ignored.");
  EXPECT_EQ(flight.notes[1], "1 of 3 rows repeat the one before them; they are left out.");
  EXPECT_FALSE(flight.known.phase);
  EXPECT_TRUE(flight.phase_changes.empty());
}

TEST(FlightCsv, AnOptionIsAdvisedByTheNameThatTheVerbHasForItOrNotAtAll) {
  const auto message = [](const std::string& options) {
    try {
      (void)read_flight_csv(Table::parse("t,speed_m_s\n0,1\n", "log.csv"), {.options = options}, nothing);
    } catch (const text::Error& error) {
      return std::string{error.what()};
    }
    return std::string{};
  };
  EXPECT_NE(message("--b-").find("; if it has another name: --b-columns time=NAME:UNIT"), std::string::npos);
  EXPECT_EQ(message("").find("--"), std::string::npos) << message("");
}

TEST(FlightCsv, AFlightThatWasWrittenComesBack) {
  const std::string text =
      "time_s,phase,roll_angle_deg,roll_rate_deg_s,reference_deg,excitation_deg,offset_estimate_deg,command_deg,"
      "saturated,command_1_deg,"
      "command_2_deg,command_3_deg,command_4_deg,encoder_1_deg,encoder_2_deg,encoder_3_deg,encoder_4_deg,canard_deg,"
      "specific_force_m_s2,height_m,speed_m_s\n"
      "-0.001000,armed,0.100000,2.000000,0.000000,0.000000,-1.500000,0.000000,0,1.000000,,3.000000,4.000000,5.000000,6."
      "000000,,"
      "8.000000,,9.806650,1.000000,2.000000\n"
      "0.000000,launched,0.100000,2.000000,0.000000,0.000000,-1.500000,0.000000,1,1.000000,,3.000000,4.000000,5.000000,"
      "6.000000,,"
      "8.000000,7.000000,9.806650,1.000000,2.000000\n";
  EXPECT_EQ(flight::csv(read(text)), text);
}

// Files of six degrees of freedom have it; those that were written before it was known have not.
TEST(FlightCsv, TheRollThatACameraSeesIsReadWhereTheFileHasIt) {
  const std::string header = "time_s,phase,true_roll_angle_deg";
  const Flight with = read(header + ",true_geometric_roll_deg\n0,armed,1,2.5\n0.001,armed,1,\n");
  EXPECT_DOUBLE_EQ(text::degrees(with.rows[0].truth.value().geometric_roll_rad.value()), 2.5);
  EXPECT_FALSE(with.rows[1].truth.value().geometric_roll_rad);
  EXPECT_TRUE(with.notes.empty());
  const Flight without = read(header + "\n0,armed,1\n");
  EXPECT_FALSE(without.rows[0].truth.value().geometric_roll_rad);
  EXPECT_FALSE(report::figures(without).camera_roll);
}

}  // namespace
}  // namespace fantail::logs
