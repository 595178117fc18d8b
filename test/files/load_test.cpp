// SPDX-License-Identifier: MIT
// What is read of files of other programs is tested with the packages that read them: readers_test.py.
#include "files/load.hpp"

#include <random>

#include <gtest/gtest.h>

#include "logs/refused.hpp"
#include "seed.hpp"
#include "system/folder.hpp"

namespace fantail::files {
namespace {

using test::expect_refused;
using text::ErrorKind;
using Names = std::vector<std::string>;

Loaded log(const std::string& text) { return parse(text, "a.csv", Writer::logger); }
flight::Table exported(const std::string& text) { return parse(text, "flight.csv", Writer::simulator).table; }

TEST(ALoggersFile, MayEndInTheMiddleOfALine) {
  const Loaded cut = log("t,a,b\n1,2,3\n2,3");
  EXPECT_EQ(cut.table.rows(), 1U);
  EXPECT_EQ(cut.notes.size(), 1U);
  EXPECT_EQ(log("t,a,b\n1,2,3\n2,3,4").table.rows(), 2U);
  expect_refused(ErrorKind::bad_data, {"a.csv:3", "2 cells"}, [] { (void)log("t,a,b\n1,2,3\n2,3\n"); });
  expect_refused(ErrorKind::bad_data, {"cut off"}, [] { (void)parse("t,a,b\n1,2,3\n2,3", "a.csv", Writer::ours); });
}

TEST(ALoggersFile, MayHaveItsHeaderBehindAHashWhereNumbersFollow) {
  EXPECT_EQ(log("#time,acceleration\n1.0,2.0\n").table.columns(), (Names{"time", "acceleration"}));
  EXPECT_EQ(log("# made by hand, for a test\nt,a\n1,2\n").table.columns(), (Names{"t", "a"}));
  expect_refused(ErrorKind::bad_data, {"only numbers"}, [] { (void)log("# no header\n1,2\n"); });
}

TEST(ALoggersFile, HasItsNamesThatComeAgainNumbered) {
  EXPECT_EQ(log("t,altitude,b,altitude,,altitude,\r\n1,2,3,4,5,6,\r\n").table.columns(),
            (Names{"t", "altitude", "b", "altitude.1", "", "altitude.2", ""}));
  expect_refused(ErrorKind::bad_data, {"twice"}, [] { (void)log("\"a,b\",\"a,b\"\n1,2\n"); });
}

// Whatever the bytes are: a table, or a refusal that names the file.
TEST(ALoggersFile, OfAnyBytesEndsInATableOrARefusal) {
  std::mt19937 random{test::seed()};
  const std::string whole = "# a, b\n#time,x,x\r\n1,2,3\n\"4\",5,NaN\n7,8,9\n";
  for (int i = 0; i < 5000; ++i) {
    std::string bytes = whole.substr(0, whole.size() - random() % 20);
    for (int change = 0; change < i % 8; ++change) {
      bytes[random() % bytes.size()] = ",\n#\"1x\r-;"[random() % 9];
    }
    for (const Writer writer : {Writer::logger, Writer::simulator}) {
      try {
        (void)parse(bytes, "a.csv", writer);
      } catch (const text::Error& error) {
        EXPECT_TRUE(std::string_view{error.what()}.starts_with("a.csv")) << error.what();
      }
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

TEST(ForeignFiles, SemicolonsAndTabsSeparateToo) {
  for (const std::string separator : {";", "\t"}) {
    const flight::Table read = exported("# a, b\n# Time (s)" + separator + "Altitude (m)\n0.5" + separator + "1.25\n");
    EXPECT_EQ(read.columns(), (Names{"Time (s)", "Altitude (m)"}));
    EXPECT_EQ(read.number(0, 1), 1.25);
    EXPECT_EQ(log("t" + separator + "a\n0.5" + separator + "1.25\n").table.number(0, 1), 1.25);
  }
}

TEST(ForeignFiles, DecimalCommasAreRefused) {
  for (const Writer writer : {Writer::logger, Writer::simulator}) {
    expect_refused(ErrorKind::bad_data, {"flight.csv:2", "comma", "semicolons", "decimal point"},
                   [&] { (void)parse("Time (s);Altitude (m)\n0,5;1,25\n", "flight.csv", writer); });
  }
}

TEST(AnExport, OfNothingOrOfNumbersWithoutNamesIsRefused) {
  expect_refused(ErrorKind::bad_data, {"flight.csv", "empty"}, [] { (void)exported(""); });
  expect_refused(ErrorKind::bad_data, {"flight.csv", "empty"}, [] { (void)exported("# Event LAUNCH occurred\n\n"); });
  expect_refused(ErrorKind::bad_data, {"flight.csv:1", "header"}, [] { (void)exported("0,1,2\n0.1,2,3\n"); });
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
  const Loaded loaded = load(folder.write("a.csv", "# AltOS\n#time,x,x\n\n1,2,3\n"), Writer::logger);
  EXPECT_EQ(loaded.table.place(0), "line 4");
  EXPECT_EQ(loaded.table.columns(), (Names{"time", "x", "x.1"}));
  ASSERT_EQ(loaded.notes.size(), 1U);
  EXPECT_NE(loaded.notes[0].find("x.1"), std::string::npos) << "which of two columns is taken is said";
}

TEST(Load, RefusesWhatIsNoTable) {
  const test::Folder folder;
  expect_refused(ErrorKind::bad_data, {"is empty"}, [&] { (void)load(folder.write("e.csv", ""), Writer::logger); });
  const auto refused = [&](const std::string& name, Writer writer, const char* allowed) {
    expect_refused(ErrorKind::bad_data, {name.c_str(), "are not read as tables", allowed},
                   [&] { (void)load(folder.write(name, "t,a\n1,2\n"), writer); });
    expect_refused(ErrorKind::no_such_input, {"none", "no such file"},
                   [&] { (void)load(folder / ("none" + name), writer); });
  };
  for (const char* name : {"log.ftl", "log.lcmlog"}) {
    refused(name, Writer::logger, "allowed: CSV (any other ending), .mat, .parquet");
  }
  for (const char* name : {"log.json", "log.lcmlog"}) {
    refused(name, Writer::ours, "allowed: CSV (any other ending), .ftl, .mat, .parquet");
  }
  for (const char* name : {"none.csv", "none.mat"}) {
    expect_refused(ErrorKind::no_such_input, {name, "no such file"}, [&] { (void)load(folder / name, Writer::ours); });
  }
}

}  // namespace
}  // namespace fantail::files
