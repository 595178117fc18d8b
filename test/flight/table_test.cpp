// SPDX-License-Identifier: MIT
#include "flight/table.hpp"

#include <string>

#include <gtest/gtest.h>

#include "logs/refused.hpp"
#include "system/folder.hpp"
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

}  // namespace
}  // namespace fantail::flight
