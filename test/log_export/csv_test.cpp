// SPDX-License-Identifier: MIT
#include <algorithm>

#include <gtest/gtest.h>

#include "flight/write_csv.hpp"
#include "json/value.hpp"
#include "log_export/formats.hpp"
#include "made_flight.hpp"

namespace fantail::log_export {
namespace {

Selection select(std::initializer_list<std::string_view> names) {
  Selection selection;
  for (const std::string_view name : names) {
    selection.push_back(find_field(name).value());
  }
  return selection;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    all.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return all;
}

TEST(CsvExport, WithoutAChoiceItIsFlightCsvByteForByteWhereEveryTickWasReplayed) {
  MadeFlight made;
  std::erase_if(made.flight.ticks, [](const auto& t) { return t.sequence >= 550 && t.sequence < 560; });
  std::erase_if(made.regeneration.records, [](const auto& record) { return !record; });
  EXPECT_EQ(flight_csv(made.source(), made.report), flight::csv(made.report));
}

// In the order of the table, none missing and none with an empty cell.
void expect_each_column_described(const std::string& table) {
  std::string names = lines(table).front();
  const json::Value columns = json::parse(columns_json(table));
  std::string described;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    described += (i == 0 ? "" : ",") + columns[i]["column"].text();
    EXPECT_FALSE(columns[i]["unit"].text().empty()) << columns[i]["column"].text();
    EXPECT_FALSE(columns[i]["description"].text().empty()) << columns[i]["column"].text();
  }
  EXPECT_EQ(described, names);
}

TEST(CsvExport, EachColumnHasItsUnitAndDescriptionBesideTheTable) {
  const MadeFlight made;
  expect_each_column_described(csv(made.source(), every_field(made.source())));
  expect_each_column_described(flight_csv(made.source(), made.report));
  const json::Value columns = json::parse(columns_json("phase,roll_rate_deg_s\n"));
  EXPECT_EQ(columns[0]["unit"].text(), "-");
  EXPECT_EQ(columns[1]["unit"].text(), "deg/s");
  EXPECT_EQ(columns[1]["description"].text(), "roll rate, bias subtracted");
}

TEST(CsvExport, ATickThatCouldNotBeReplayedHasItsRowWithWhatTheLogHoldsAndAMark) {
  const MadeFlight made;
  const auto all = lines(flight_csv(made.source(), made.report));
  ASSERT_EQ(all.size(), 951U);  // a thousand, of which fifty are missing, and the names
  EXPECT_TRUE(all[0].ends_with(",speed_m_s,replayed")) << all[0];
  std::vector<std::string> replayed;
  for (const std::string& line : all) {
    if (line.ends_with(",1")) {
      replayed.push_back(line.substr(0, line.size() - 2));
    }
  }
  auto rows = lines(flight::csv(made.report));
  rows.erase(rows.begin());
  EXPECT_EQ(replayed, rows);
  // Tick 550, the first behind the gap: encoder 1 shows 550 of 16384, encoder 2 one count less than nothing.
  const std::string before_encoder_2 = "0.450000,controlling,,,,,,2.750000,0,6.500000,7.500000,8.500000,,12.084961,";
  ASSERT_TRUE(all[501].starts_with(before_encoder_2)) << all[501];
  EXPECT_TRUE(all[501].ends_with(",0.000000,,,,,,0")) << all[501];
  EXPECT_NEAR(std::stod(all[501].substr(before_encoder_2.size())), -360.0 / 16384.0, 3e-5) << "a float of a whole turn";
  EXPECT_TRUE(all[510].ends_with(",0")) << all[510];
  EXPECT_TRUE(all[511].ends_with(",1")) << all[511];
}

TEST(CsvExport, OfAWindowTheRowsAtBothEndsAreThereAndNoOthers) {
  const MadeFlight made;
  const auto rows = lines(flight_csv(made.source({.from_s = 0.1, .until_s = 0.15}), made.report));
  ASSERT_EQ(rows.size(), 52U);
  EXPECT_EQ(rows[1].substr(0, 9), "0.100000,");
  EXPECT_EQ(rows[51].substr(0, 9), "0.150000,");
}

TEST(CsvExport, ChosenFieldsStandInTheirOrderWithOneRowForEachTickOfTheLog) {
  const MadeFlight made;
  const auto rows = lines(csv(made.source(), select({"speed_m_s", "time_s", "phase", "rate_y_count", "saturated"})));
  ASSERT_EQ(rows.size(), 951U);
  EXPECT_EQ(rows[0], "speed_m_s,time_s,phase,rate_y_count,saturated");
  EXPECT_EQ(rows[1], "0.000000,-0.100000,armed,0,0");
  EXPECT_EQ(rows[401], "50.000000,0.300000,controlling,-400,0");
}

TEST(CsvExport, WhatIsUnknownIsAnEmptyCellAndAGapIsAGapInTime) {
  const MadeFlight made;
  const auto rows = lines(csv(made.source(), select({"time_s", "speed_m_s", "command_4_deg", "digest"})));
  EXPECT_EQ(rows[500], "0.399000,62.375000,,4294902259");
  EXPECT_EQ(rows[501], "0.450000,,,4294902310");  // not replayed
}

TEST(CsvExport, AFieldOfAWindowThatHoldsNoTickIsAHeaderAlone) {
  const MadeFlight made;
  EXPECT_EQ(csv(made.source({.from_s = 5.0}), select({"time_s"})), "time_s\n");
}

}  // namespace
}  // namespace fantail::log_export
