// SPDX-License-Identifier: MIT
#include "trajectory/exported_table.hpp"

#include <gtest/gtest.h>

#include "logs/refused.hpp"

namespace fantail::trajectory {
namespace {

using test::expect_refused;
using text::ErrorKind;

flight::Table table(const std::string& text) { return exported_table(text, "flight.csv"); }

TEST(ExportedTable, TheLastCommentWithATimeBeforeTheRowsIsTheHeader) {
  const flight::Table read = table(
      "# Time trial (Up to date)\n# 2 data points\n#\n# Time (s),Altitude (m)\n# Event LAUNCH occurred at t=0 seconds\n"
      "0,1\n# Event LIFTOFF occurred at t=0.01 seconds\n0.1,2\n");
  EXPECT_EQ(read.columns(), (std::vector<std::string>{"Time (s)", "Altitude (m)"}));
  EXPECT_EQ(read.rows(), 2U);
  EXPECT_EQ(read.header_line(), 4U);
  EXPECT_EQ(read.line(1), 8U);
}

TEST(ExportedTable, AHeaderThatIsNoCommentWillDo) {
  EXPECT_EQ(table("# a comment\nTime (s),Z (m)\n0,1\n").columns(), (std::vector<std::string>{"Time (s)", "Z (m)"}));
}

TEST(ExportedTable, AByteOrderMarkAndCarriageReturnsDoNoHarm) {
  const flight::Table read = table("\xEF\xBB\xBF# Time (s),Altitude (m)\r\n0,1\r\n0.1,2\r\n");
  EXPECT_EQ(read.columns(), (std::vector<std::string>{"Time (s)", "Altitude (m)"}));
  EXPECT_EQ(read.number(1, 1), 2.0);
}

TEST(ExportedTable, SemicolonsAndTabsSeparateToo) {
  for (const std::string separator : {";", "\t"}) {
    const flight::Table read = table("# a, b\n# Time (s)" + separator + "Altitude (m)\n0.5" + separator + "1.25\n");
    EXPECT_EQ(read.columns(), (std::vector<std::string>{"Time (s)", "Altitude (m)"}));
    EXPECT_EQ(read.number(0, 1), 1.25);
  }
}

TEST(ExportedTable, DecimalCommasAreRefused) {
  expect_refused(ErrorKind::bad_data, {"flight.csv:2", "comma", "semicolons", "decimal point"},
                 [] { (void)table("# Time (s);Altitude (m)\n0,5;1,25\n"); });
}

TEST(ExportedTable, AnEmptyFileAndNumbersWithoutNamesAreRefused) {
  expect_refused(ErrorKind::bad_data, {"flight.csv", "empty"}, [] { (void)table(""); });
  expect_refused(ErrorKind::bad_data, {"flight.csv", "empty"}, [] { (void)table("# Event LAUNCH occurred\n\n"); });
  expect_refused(ErrorKind::bad_data, {"flight.csv:1", "header"}, [] { (void)table("0,1,2\n0.1,2,3\n"); });
}

// Fourteen numbers under eleven names.
TEST(ExportedTable, WhatRocketPyExportsWithoutNamesOfVariablesIsRefusedWithWhatToDo) {
  expect_refused(ErrorKind::bad_data, {"flight.csv:1", "RocketPy", "velocities", "export_data(", "time_step=0.01"}, [] {
    (void)table(
        "# Time (s),X (m),Y (m),Z (m),E0,E1,E2,E3,W1 (rad/s),W2 (rad/s),W3 (rad/s)\n0,0,0,0,0,0,0,1,0,0,0,0,0,0\n");
  });
}

}  // namespace
}  // namespace fantail::trajectory
