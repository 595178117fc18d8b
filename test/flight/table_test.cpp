// SPDX-License-Identifier: MIT

#include "flight/table.hpp"

#include "flight/write_csv.hpp"
#include "logs/refused.hpp"
#include "system/folder.hpp"
#include "test.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::flight {
namespace {

using test::expect_refused;
using text::ErrorKind;

Table parse(const std::string& text) { return Table::parse(text, "log.csv"); }

void expect_bad(const std::string& text, std::initializer_list<const char*> words) {
  expect_refused(ErrorKind::bad_data, words, [&] { (void)parse(text); });
}

TEST(Table, HasAHeaderAndCellsInRows) {
  const Table table = parse("a,b\n1,x\n-2.5e3,\n");
  EXPECT_EQ(table.columns(), (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.cell(0, 1), "x");
  EXPECT_EQ(table.number(0, 0), 1.0);
  EXPECT_EQ(table.number(1, 0), -2500.0);
  EXPECT_EQ(table.cell(1, 1), "");
  EXPECT_EQ(table.number(1, 1), std::nullopt);
  EXPECT_EQ(table.find("b"), 1U);
  EXPECT_EQ(table.find("c"), std::nullopt);
}

TEST(Table, ReadsAnyLineEndAndAByteOrderMark) {
  for (const std::string& text : {std::string{"a,b\n1,2\n"}, std::string{"a,b\r\n1,2\r\n"}, std::string{"a,b\n1,2"},
                                  std::string{"\xEF\xBB\xBF"} + "a,b\r\n1,2"}) {
    const Table table = parse(text);
    EXPECT_EQ(table.columns(), (std::vector<std::string>{"a", "b"})) << text;
    ASSERT_EQ(table.rows(), 1U) << text;
    EXPECT_EQ(table.number(0, 1), 2.0) << text;
  }
}

TEST(Table, TakesSpacesAndQuotesAway) {
  const Table table = parse(" a\t, \"b, with \"\"comma\"\"\" ,\"c\"  \n 1 ,\"2\",\" 3 \"\n");
  EXPECT_EQ(table.columns(), (std::vector<std::string>{"a", "b, with \"comma\"", "c"}));
  EXPECT_EQ(table.number(0, 0), 1.0);
  EXPECT_EQ(table.number(0, 1), 2.0);
  EXPECT_EQ(table.number(0, 2), 3.0);
}

TEST(Table, SkipsWhatSaysNothingAndCountsItsLines) {
  const Table table = parse("# made by hand\n\na,b\n \t\n1,2\n,\n# 7,8\n3,4\n");
  ASSERT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.line(0), 5U);
  EXPECT_EQ(table.line(1), 8U);
  EXPECT_EQ(table.where(1), "log.csv:8");
}

TEST(Table, KeepsItsCellsWhenItMoves) {
  Table first = parse("a\n1\n");
  const Table second = std::move(first);
  EXPECT_EQ(second.cell(0, 0), "1");
}

TEST(Table, RefusesARowOfAnotherLength) {
  expect_bad("a,b\n1,2\n3\n4,5\n", {"log.csv:3: ", "1 cell where the header has 2"});
  expect_bad("a,b\n1,2\n3,4,5\n", {"log.csv:3: ", "3 cells where the header has 2"});
  expect_bad("a,b,c\n1,2,3\n4,5", {"log.csv:3: ", "the last line seems to be cut off"});
}

TEST(Table, RefusesAFileWithoutAHeader) {
  expect_bad("", {"log.csv: ", "is empty"});
  expect_bad("\xEF\xBB\xBF\n# nothing\n", {"log.csv: ", "is empty"});
  expect_bad("\n0.1,2\n0.2,3\n", {"log.csv:2: ", "only numbers", "header"});
}

TEST(Table, RefusesANameThatStandsTwice) {
  expect_bad("a,b,a\n", {"log.csv:1: ", "\"a\" appears twice"});
  EXPECT_NO_THROW((void)parse("a,,\n1,,\n"));  // spreadsheets add columns without a name
}

TEST(Table, RefusesOtherSeparatorsInWords) {
  expect_bad("time_s;roll\n1;2\n", {"log.csv:1: ", "semicolons", "commas are expected"});
  expect_bad("time_s\troll\n1\t2\n", {"log.csv:1: ", "tabs"});
}

TEST(Table, RefusesAQuoteThatSwallowsTheRest) {
  expect_bad("a,b\n\"1,2\n3,4\n", {"log.csv:2: ", "a quoted cell does not end"});
  expect_bad("a,b\n\"1\"0,2\n", {"log.csv:2: ", "after a closing quote"});
}

TEST(Table, RefusesWhatIsNoText) { expect_bad(std::string{"a,b\n1,\0\n", 8}, {"log.csv: ", "zero bytes"}); }

TEST(Table, NamesAMissingColumnAndThoseThatAreThere) {
  const Table table = parse("time_s,roll_angle\n1,2\n");
  expect_refused(
      ErrorKind::bad_data,
      {"log.csv: no column roll_angle_deg", "did you mean roll_angle?", "the columns are: time_s, roll_angle"},
      [&] { (void)table.column("roll_angle_deg"); });
}

TEST(Table, AMessageHoldsNoControlCharactersAndStaysShort) {
  const std::string name(10'000, 'x');
  try {
    (void)parse("\x1B[31m,b," + name + "\n").column("c");
    ADD_FAILURE();
  } catch (const text::Error& error) {
    EXPECT_EQ(std::string{error.what()}.find('\x1B'), std::string::npos);
    EXPECT_LT(std::string{error.what()}.size(), 200U);
  }
}

TEST(Table, LoadsAFileAndSaysWhenThereIsNone) {
  const test::Folder folder;
  EXPECT_EQ(Table::load(folder.write("a.csv", "a\n7\n")).number(0, 0), 7.0);
  expect_refused(ErrorKind::no_such_input, {"none.csv: no such file"}, [&] { (void)Table::load(folder / "none.csv"); });
  expect_refused(ErrorKind::no_such_input, {"is a folder"}, [&] { (void)Table::load(folder.path().string()); });
}

TEST(Number, IsFiniteAndNothingElse) {
  EXPECT_EQ(text::number(" +1.5 "), 1.5);
  EXPECT_EQ(text::number("-.5"), -0.5);
  EXPECT_EQ(text::number("1E3"), 1000.0);
  for (const char* text : {"", " ", "nan", "inf", "-inf", "1e999", "1,5", "1 2", "+-1", "--1", "0x10", "12a", "\""}) {
    EXPECT_EQ(text::number(text), std::nullopt) << text;
  }
}

const std::string measured_header =
    "time_s,phase,roll_angle_deg,roll_rate_deg_s,reference_deg,excitation_deg,offset_estimate_deg,command_deg,"
    "saturated,command_1_deg,"
    "command_2_deg,command_3_deg,command_4_deg,encoder_1_deg,encoder_2_deg,encoder_3_deg,encoder_4_deg,canard_deg,"
    "specific_force_m_s2,height_m,speed_m_s";

std::string second_line(const Flight& flight) {
  const std::string text = csv(flight);
  const std::size_t begin = text.find('\n') + 1;
  return text.substr(begin, text.find('\n', begin) - begin);
}

Row some_row() {
  Row row;
  row.time_s = 1.25;
  row.phase = core::Phase::controlling;
  row.roll_angle_rad = text::radians(-12.5);
  row.roll_rate_rad_s = text::radians(100.0);
  row.reference_rad = text::radians(-20.0);
  row.excitation_rad = text::radians(4.0);
  row.offset_estimate_rad = text::radians(-2.0);
  row.command_rad = text::radians(9.0);
  row.saturated = true;
  row.commands_rad = {text::radians(1.0), text::radians(2.0), text::radians(3.0), text::radians(4.0)};
  row.encoders_rad = {text::radians(1.5), text::radians(2.5), text::radians(3.5), text::radians(4.5)};
  row.canard_rad = text::radians(3.0);
  row.specific_force_m_s2 = 9.80665;
  row.height_m = 6.0;
  row.speed_m_s = 25.0;
  return row;
}

TEST(Csv, HeaderIsTheContractWordForWord) {
  Flight flight;
  flight.rows = {some_row()};
  flight.rows[0].truth = Truth{};
  const std::string text = csv(flight);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            measured_header +
                ",true_roll_angle_deg,true_roll_rate_deg_s,true_canard_deg,true_height_m,true_speed_m_s,"
                "true_disturbance_deg");
}

TEST(Csv, TheRollThatACameraSeesHasAColumnInSixDegreesOfFreedomOnly) {
  Flight flight;
  flight.rows = {some_row()};
  flight.rows[0].truth = Truth{.geometric_roll_rad = text::radians(7.5)};
  const std::string text = csv(flight);
  EXPECT_TRUE(text.substr(0, text.find('\n')).ends_with(",true_disturbance_deg,true_geometric_roll_deg")) << text;
  EXPECT_TRUE(second_line(flight).ends_with(",7.500000")) << text;
}

TEST(Csv, WithoutTruthThereAreNoTrueColumns) {
  Flight flight;
  flight.rows = {some_row()};
  EXPECT_EQ(csv(flight).substr(0, measured_header.size() + 1), measured_header + "\n");
}

TEST(Csv, AFlightWithoutRowsIsAHeader) { EXPECT_EQ(csv(Flight{}), measured_header + "\n"); }

TEST(Csv, ARowHoldsDegreesWithSixDecimalsAndThePhaseAsAWord) {
  Flight flight;
  flight.rows = {some_row()};
  EXPECT_EQ(
      second_line(flight),
      "1.250000,controlling,-12.500000,100.000000,-20.000000,4.000000,-2.000000,9.000000,1,1.000000,2.000000,3.000000,"
      "4.000000,1.500000,2.500000,3.500000,4.500000,3.000000,9.806650,6.000000,25.000000");
}

TEST(Csv, TruthFollowsInItsOwnColumns) {
  Flight flight;
  flight.rows = {some_row()};
  flight.rows[0].truth =
      Truth{text::radians(1.0), text::radians(-2.0), text::radians(3.0), 400.5, 80.25, text::radians(-7.3)};
  EXPECT_TRUE(second_line(flight).ends_with(",25.000000,1.000000,-2.000000,3.000000,400.500000,80.250000,-7.300000"));
}

TEST(Csv, WhatNobodyKnewIsAnEmptyCell) {
  Flight flight;
  flight.rows = {some_row(), some_row()};
  flight.rows[0].commands_rad[0].reset();
  flight.rows[0].encoders_rad[2].reset();
  flight.rows[0].canard_rad.reset();
  flight.rows[1].truth = Truth{};
  const std::string line = second_line(flight);
  EXPECT_NE(line.find(",1,,2.000000,"), std::string::npos);
  EXPECT_NE(line.find(",2.500000,,4.500000,,9.806650,"), std::string::npos);
  EXPECT_TRUE(line.ends_with(",25.000000,,,,,,"));
}

TEST(Csv, EveryRowHasAsManyCellsAsTheHeader) {
  Flight flight;
  flight.rows = {some_row(), Row{}, some_row()};
  flight.rows[2].truth = Truth{};
  const std::string text = csv(flight);
  std::size_t begin = 0;
  for (int line = 0; line < 4; ++line) {
    const std::size_t end = text.find('\n', begin);
    ASSERT_NE(end, std::string::npos);
    EXPECT_EQ(std::count(text.begin() + static_cast<std::ptrdiff_t>(begin),
                         text.begin() + static_cast<std::ptrdiff_t>(end), ','),
              26)
        << "line " << line;
    begin = end + 1;
  }
  EXPECT_EQ(begin, text.size());
}

TEST(Csv, ANegativeZeroIsAZero) {
  Flight flight;
  flight.rows = {some_row()};
  flight.rows[0].roll_angle_rad = -0.0;
  flight.rows[0].roll_rate_rad_s = -1e-12;
  EXPECT_NE(second_line(flight).find("controlling,0.000000,0.000000,"), std::string::npos);
}

TEST(TunnelCsv, HasOneRowForEachReadingOnTheRowsClock) {
  Flight flight;
  flight.tunnel_readings = {{8.0, 570.0, 10.1}, {10.0, 870.0, 10.0}};
  set_time_zero(flight, 10.0);
  EXPECT_EQ(tunnel_csv(flight),
            "time_s,fan_rpm,wind_speed_m_s\n-2.000000,570.000000,10.100000\n0.000000,870.000000,10.000000\n");
}

}  // namespace

}  // namespace fantail::flight
