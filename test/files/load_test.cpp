// SPDX-License-Identifier: MIT
// What is read of files of other programs is tested with the packages that read them: readers_test.py.
#include "files/load.hpp"

#include <algorithm>
#include <random>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "logs/refused.hpp"
#include "seed.hpp"
#include "system/folder.hpp"

namespace fantail::files {
namespace {

using test::expect_refused;
using text::ErrorKind;
using Names = std::vector<std::string>;

Loaded log(const std::string& text) { return parse(text, "a.csv"); }
flight::Table exported(const std::string& text) { return parse(text, "flight.csv").table; }

TEST(SomebodysTable, MayEndInTheMiddleOfALine) {
  const Loaded cut = log("t,a,b\n1,2,3\n2,3");
  EXPECT_EQ(cut.table.rows(), 1U);
  EXPECT_EQ(cut.notes.size(), 1U);
  EXPECT_EQ(log("t,a,b\n1,2,3\n2,3,4").table.rows(), 2U);
  expect_refused(ErrorKind::bad_data, {"cut off"}, [] { (void)log("time_s,a,b\n1,2,3\n2,3"); });
}

TEST(SomebodysTable, MayHaveRowsWithFewerCellsThanNames) {
  const Loaded short_rows = log("t,a,b\n1,2,3\n2,3\n3,4,5\n");
  EXPECT_EQ(short_rows.table.rows(), 3U);
  EXPECT_EQ(short_rows.table.number(1, 1), 3.0);
  EXPECT_EQ(short_rows.table.number(1, 2), std::nullopt);
  ASSERT_EQ(short_rows.notes.size(), 1U);
  EXPECT_NE(short_rows.notes[0].find("(first: line 3)"), std::string::npos) << short_rows.notes[0];
  EXPECT_EQ(log("t,a\n1,2,,\n2,3\n").table.rows(), 2U);
  expect_refused(ErrorKind::bad_data, {"a.csv:3", "3 cells"}, [] { (void)log("t,a\n1,2\n2,3,4\n"); });
}

TEST(SomebodysTable, MayHaveItsHeaderBehindAHashAndBelowLinesAboutTheLogger) {
  EXPECT_EQ(log("#time,acceleration\n1.0,2.0\n").table.columns(), (Names{"time", "acceleration"}));
  EXPECT_EQ(log("# made by hand, for a test\nt,a\n1,2\n").table.columns(), (Names{"t", "a"}));
  const Loaded meta = log("Logger: X1\nDate: 2026-03-01\nFirmware: 3.2\n\ntime_x,a\ns,deg\n0.5,2\n0.6,3\n");
  EXPECT_EQ(meta.table.columns(), (Names{"time_x", "a"})) << "units are no names";
  EXPECT_EQ(meta.table.rows(), 2U);
  EXPECT_EQ(meta.table.where(0), "a.csv:7");
}

TEST(SomebodysTable, WithoutNamesHasNumbersForThem) {
  const Loaded bare = log("0.0,1,2\n0.1,3,4\n");
  EXPECT_EQ(bare.table.columns(), (Names{"#1", "#2", "#3"}));
  EXPECT_EQ(bare.table.rows(), 2U);
  EXPECT_EQ(bare.table.where(0), "a.csv:1");
  ASSERT_EQ(bare.notes.size(), 1U);
  EXPECT_NE(bare.notes[0].find("no names"), std::string::npos);
}

TEST(SomebodysTable, OfPerfectFliteHasItsNamesInParentheses) {
  const Loaded pf2 =
      log("PerfectFlite SL100\r\nApogee: 1234' AGL\r\n\r\n"
          "Data: (Time, Altitude, Velocity, Temperature (F), Voltage)\r\n0.00,0,0,70.1,9.1\r\n0.05,12,31,70.1,9.1\r\n");
  EXPECT_EQ(pf2.table.columns(), (Names{"Time", "Altitude", "Velocity", "Temperature (F)", "Voltage"}));
  EXPECT_EQ(pf2.table.number(1, 1), 12.0);
}

TEST(SomebodysTable, MayHaveSpacesBetweenItsNamesAndCommasBetweenItsNumbers) {
  const Loaded arts = log("# MET Acc Vel iAlt pAlt \n0.000,0.00,2.11,0.09,0.00\n0.020,6.57,7.14,0.30,0.00\n");
  EXPECT_EQ(arts.table.columns(), (Names{"MET", "Acc", "Vel", "iAlt", "pAlt"}));
  EXPECT_EQ(arts.table.rows(), 2U);
}

TEST(SomebodysTable, DoesNotTakeACommentThatASpreadsheetHasFilledWithCommasForItsNames) {
  const Loaded table =
      log("# Time (s),Altitude (m),Speed (m/s)\n# Event LAUNCH occurred at t=0 seconds,,\n0,1,2\n1,2,3\n");
  EXPECT_EQ(table.table.columns(), (Names{"Time (s)", "Altitude (m)", "Speed (m/s)"}));
  const Loaded six = log("# a,b,c,d,e,f\n# Event LAUNCH occurred at t=0 seconds\n0,1,2,3,4,5\n1,2,3,4,5,6\n");
  EXPECT_EQ(six.table.columns(), (Names{"a", "b", "c", "d", "e", "f"})) << "six words are no six names";
}

TEST(SomebodysTable, WithATimeForEveryFewColumnsIsReadAsOneInOrderOfTime) {
  const Loaded raven =
      log("Time@Axial Accel (Gs),Axial Accel (Gs),bILBA,Time@Baro (Atm),Baro (Atm),bILBA\n"
          "0,1.0,b0,0.25,0.9,b1\n0.1,5.5,b0,0.75,0.8,b1\n0.3,2.5,b0,,,\n");
  EXPECT_TRUE(raven.several_clocks);
  ASSERT_EQ(raven.table.columns(), (Names{"time", "Axial Accel (Gs)", "bILBA", "Baro (Atm)", "bILBA.1"}));
  ASSERT_EQ(raven.table.rows(), 5U);
  const std::vector<double> times{0.0, 0.1, 0.25, 0.3, 0.75};
  for (std::size_t row = 0; row < times.size(); ++row) {
    EXPECT_EQ(raven.table.number(row, 0), times[row]);
    EXPECT_EQ(raven.table.number(row, 1).has_value(), row != 2 && row != 4) << row;
    EXPECT_EQ(raven.table.number(row, 3).has_value(), row == 2 || row == 4) << row;
  }
  EXPECT_EQ(raven.table.number(3, 1), 2.5);
  EXPECT_FALSE(log("time,a,b\n0,1,2\n1,2,3\n").several_clocks);
}

TEST(TheRawTextOfABlueRaven, IsATableWithTheUnitsOfTheExport) {
  const std::string whole =
      "@ LOG_HIR  139 2023  8 09 23:59:59.998   75     65    -22   -133    -66    -21    -55  -3000   3000    -30  "
      "29655     22  "
      "    0 CRC: 43F1\n"
      "@ LOG_HIR  139 2023  8 10 00:00:00.000   77  10000    -21   -124   3100    -23    -52  -3304   3097    -34  "
      "29656     22  "
      "    0 CRC: 8772\n";
  const Loaded raw = log(whole + "@ LOG_HIR  139 2023  8 10 00:00:00.002   79  @ LOG_HIR\n");
  const auto number = [&](std::size_t row, std::string_view column) {
    return raw.table.number(row, raw.table.column(column)).value();
  };
  ASSERT_EQ(raw.table.rows(), 2U);
  EXPECT_DOUBLE_EQ(number(0, "Flight_Time_(s)"), 0.0);
  EXPECT_DOUBLE_EQ(number(1, "Flight_Time_(s)"), 0.002) << "across midnight";
  EXPECT_DOUBLE_EQ(number(0, "Gyro_Z"), -1.33);
  EXPECT_DOUBLE_EQ(number(1, "Gyro_X"), 100.0);
  EXPECT_DOUBLE_EQ(number(1, "Accel_X"), 31.0);
  EXPECT_DOUBLE_EQ(number(0, "Quat_1"), 0.9885) << "the scalar, which stands last";
  EXPECT_DOUBLE_EQ(number(0, "Quat_2"), -0.1);
  ASSERT_EQ(raw.notes.size(), 2U);
  EXPECT_NE(raw.notes[1].find("1 of 3"), std::string::npos) << raw.notes[1];
}

TEST(SomebodysTable, HasItsNamesThatComeAgainNumbered) {
  EXPECT_EQ(log("t,altitude,b,altitude,,altitude,\r\n1,2,3,4,5,6,\r\n").table.columns(),
            (Names{"t", "altitude", "b", "altitude.1", "", "altitude.2", ""}));
  EXPECT_EQ(log("\"a,b\",\"a,b\"\n1,2\n").table.columns(), (Names{"a,b", "a,b.1"}));
}

TEST(SomebodysTable, IsReadWithTheSeparatorsAndCommasOfItsCountry) {
  const auto same = [](const std::string& text) {
    const flight::Table table = log(text).table;
    EXPECT_EQ(table.columns(), (Names{"time", "rate"})) << text;
    ASSERT_EQ(table.rows(), 2U) << text;
    EXPECT_EQ(table.number(0, 0), 0.5) << text;
    EXPECT_EQ(table.number(1, 1), -1234.25) << text;
  };
  same("time,rate\n0.5,1\n0.6,-1234.25\n");
  same("time;rate\n0,5;1\n0,6;-1234,25\n");
  same("time\trate\n0,5\t1\n0,6\t-1234,25\n");
  same("time;rate\n0.5;1\n0.6;-1,234.25\n");
  same("sep=;\ntime;rate\n0,5;1\n0,6;-1234,25\n");
  same("sep=,\ntime,rate\n0.5,1\n0.6,-1234.25\n");
  same("time,rate\n\"0,5\",\"1\"\n\"0,6\",\"-1234,25\"\n");
  std::string wide = "\xFF\xFE";
  for (const char c : std::string{"time;rate\r\n0,5;1\r\n0,6;-1234,25\r\n"}) {
    wide += c;
    wide += '\0';
  }
  same(wide);
}

// The same numbers, whatever separates and marks them.
TEST(SomebodysTable, OfRandomNumbersIsTheSameInEveryNotation) {
  std::mt19937 random{test::seed()};
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t columns = 2 + random() % 6;
    const std::size_t rows = 2 + random() % 20;
    std::vector<std::vector<double>> values(rows);
    for (auto& row : values) {
      for (std::size_t i = 0; i < columns; ++i) {
        row.push_back(static_cast<double>(static_cast<int>(random() % 2'000'001) - 1'000'000) / 128.0);
      }
    }
    for (const auto& [separator, point] : {std::pair{',', '.'}, {';', ','}, {';', '.'}, {'\t', ','}, {'\t', '.'}}) {
      std::string text = "Made by a test\n\n";
      for (std::size_t i = 0; i < columns; ++i) {
        text += (i == 0 ? "" : std::string{separator}) + "name" + std::to_string(i);
      }
      text += "\n";
      for (const auto& row : values) {
        for (std::size_t i = 0; i < columns; ++i) {
          std::string number = fmt::format("{:.7f}", row[i]);
          std::ranges::replace(number, '.', point);
          text += (i == 0 ? "" : std::string{separator}) + number;
        }
        text += "\n";
      }
      const flight::Table table = log(text).table;
      ASSERT_EQ(table.rows(), rows) << text;
      ASSERT_EQ(table.columns().size(), columns) << text;
      for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t i = 0; i < columns; ++i) {
          ASSERT_EQ(table.number(row, i), values[row][i]) << text;
        }
      }
    }
  }
}

// Whatever the bytes are: a table, or a refusal that names the file.
TEST(SomebodysTable, OfAnyBytesEndsInATableOrARefusal) {
  std::mt19937 random{test::seed()};
  const std::string whole = "# a, b\n#time,x,x\r\n1,2,3\n\"4\",5,NaN\n7,8,9\n";
  for (int i = 0; i < 5000; ++i) {
    std::string bytes = whole.substr(0, whole.size() - random() % 20);
    for (int change = 0; change < i % 8; ++change) {
      bytes[random() % bytes.size()] = ",\n#\"1x\r-;"[random() % 9];
    }
    try {
      (void)parse(bytes, "a.csv");
    } catch (const text::Error& error) {
      EXPECT_TRUE(std::string_view{error.what()}.starts_with("a.csv")) << error.what();
    }
  }
}

TEST(AnExport, HasItsHeaderInTheLastCommentWithATimeBeforeTheRows) {
  const flight::Table read = exported(
      "# Time trial (Up to date)\n# 2 data points\n#\n# Time (s),Altitude (m)\n# Event LAUNCH occurred at t=0 seconds\n"
      "0,1\n# Event LIFTOFF occurred at t=0.01 seconds\n0.1,2\n");
  EXPECT_EQ(read.columns(), (Names{"Time (s)", "Altitude (m)"}));
  EXPECT_EQ(read.rows(), 2U);
  EXPECT_EQ(read.header_line(), 4U);
  EXPECT_EQ(read.line(1), 8U);
  EXPECT_EQ(exported("# a comment\nTime (s),Z (m)\n0,1\n").columns(), (Names{"Time (s)", "Z (m)"}));
  EXPECT_EQ(exported("\xEF\xBB\xBF# Time (s),Altitude (m)\r\n0,1\r\n0.1,2\r\n").number(1, 1), 2.0);
}

TEST(AnExport, OfNothingIsRefused) {
  expect_refused(ErrorKind::bad_data, {"flight.csv", "empty"}, [] { (void)exported(""); });
  expect_refused(ErrorKind::bad_data, {"flight.csv", "empty"}, [] { (void)exported("# Event LAUNCH occurred\n\n"); });
}

// Fourteen numbers under eleven names.
TEST(AnExport, OfRocketPyWithoutNamesOfVariablesIsRefusedWithWhatToDo) {
  expect_refused(ErrorKind::bad_data, {"flight.csv:1", "RocketPy", "velocities", "export_data(", "time_step=0.01"}, [] {
    (void)exported(
        "# Time (s),X (m),Y (m),Z (m),E0,E1,E2,E3,W1 (rad/s),W2 (rad/s),W3 (rad/s)\n0,0,0,0,0,0,0,1,0,0,0,0,0,0\n");
  });
}

TEST(Load, KeepsTheLinesOfTheFile) {
  const test::Folder folder;
  const Loaded loaded = load(folder.write("a.csv", "# AltOS\n#time,x,x\n\n1,2,3\n"), Beside::nothing);
  EXPECT_EQ(loaded.table.place(0), "line 4");
  EXPECT_EQ(loaded.table.columns(), (Names{"time", "x", "x.1"}));
  ASSERT_EQ(loaded.notes.size(), 1U);
  EXPECT_NE(loaded.notes[0].find("x.1"), std::string::npos) << "which of two columns is taken is said";
}

TEST(Load, NamesWhatAFileIsThatIsNoTable) {
  const test::Folder folder;
  for (const auto& [bytes, said] :
       {std::pair{"\xA3\x95\x80\x80\x01", "an ArduPilot DataFlash log; let its name end in .bin"},
        {"H Product:Blackbox flight data recorder\n", "a Betaflight black box"},
        {"PAR1....", "a Parquet file; let its name end in .parquet"},
        {"VERSION 9 CALL N0CALL SERIAL 1 FLIGHT 2", "a telemetry file of AltOS"},
        {"{ \"config_major\": 1, \"log_format\": 5 }\n", "a flash image of AltOS"}}) {
    expect_refused(ErrorKind::bad_data, {"x.log: cannot be read as a table: it is ", said},
                   [&] { (void)load(folder.write("x.log", bytes), Beside::nothing); });
  }
}

TEST(Load, RefusesWhatIsNoTable) {
  const test::Folder folder;
  expect_refused(ErrorKind::bad_data, {"is empty"}, [&] { (void)load(folder.write("e.csv", ""), Beside::nothing); });
  const auto refused = [&](const std::string& name, Beside beside, const char* allowed) {
    expect_refused(ErrorKind::bad_data, {name.c_str(), "are not read as tables", allowed},
                   [&] { (void)load(folder.write(name, "t,a\n1,2\n"), beside); });
    expect_refused(ErrorKind::no_such_input, {"none", "no such file"},
                   [&] { (void)load(folder / ("none" + name), beside); });
  };
  for (const char* name : {"log.ftl", "log.lcmlog"}) {
    refused(name, Beside::nothing, "allowed: CSV (any other ending), .mat, .parquet");
  }
  for (const char* name : {"log.json", "log.lcmlog"}) {
    refused(name, Beside::ftl, "allowed: CSV (any other ending), .ftl, .mat, .parquet");
  }
  for (const char* name : {"none.csv", "none.mat"}) {
    expect_refused(ErrorKind::no_such_input, {name, "no such file"}, [&] { (void)load(folder / name, Beside::ftl); });
  }
}

}  // namespace
}  // namespace fantail::files
