// SPDX-License-Identifier: MIT
#include "listen/load.hpp"

#include <random>

#include <gtest/gtest.h>

#include "listen/refused.hpp"
#include "random/seed.hpp"
#include "system/folder.hpp"

namespace fantail::listen {
namespace {

std::string tidied(const std::string& text) {
  std::vector<std::string> notes;
  return tidy(text, notes);
}

TEST(Tidy, LeavesOutALastLineThatIsCutOffAndSaysSo) {
  std::vector<std::string> notes;
  EXPECT_EQ(tidy("t,a,b\n1,2,3\n2,3", notes), "t,a,b\n1,2,3\n");
  EXPECT_EQ(notes.size(), 1U);
  EXPECT_EQ(tidy("t,a,b\n1,2,3\n2,3,4", notes), "t,a,b\n1,2,3\n2,3,4");
  EXPECT_EQ(tidy("t,a,b\n1,2,3\n2,3\n", notes), "t,a,b\n1,2,3\n2,3\n") << "that is another fault";
  EXPECT_EQ(notes.size(), 1U);
}

TEST(Tidy, TakesAHeaderBehindAHashWhereNumbersFollow) {
  EXPECT_EQ(tidied("#time,acceleration\n1.0,2.0\n"), "time,acceleration\n1.0,2.0\n");
  EXPECT_EQ(tidied("# made by hand, for a test\nt,a\n1,2\n"), "# made by hand, for a test\nt,a\n1,2\n");
  EXPECT_EQ(tidied("# no header\n1,2\n"), "# no header\n1,2\n") << "no comma: a remark";
}

TEST(Tidy, NumbersNamesThatComeAgain) {
  EXPECT_EQ(tidied("t,altitude,b,altitude,,altitude,\r\n1,2,3,4,5,6,\r\n"),
            "t,altitude,b,altitude.1,,altitude.2,\n1,2,3,4,5,6,\r\n");
}

TEST(Tidy, LeavesQuotedNamesAlone) {
  EXPECT_EQ(tidied("\"a,b\",\"a,b\"\n1,2\n"), "\"a,b\",\"a,b\"\n1,2\n");
  EXPECT_EQ(tidied(""), "");
}

// Whatever the bytes are: a table, or a refusal that names the file.
TEST(Tidy, OfAnyBytesEndsInATableOrARefusal) {
  std::mt19937 random{test::seed()};
  const std::string whole = "# a, b\n#time,x,x\r\n1,2,3\n\"4\",5,NaN\n7,8,9\n";
  for (int i = 0; i < 5000; ++i) {
    std::string bytes = whole.substr(0, whole.size() - random() % 20);
    for (int change = 0; change < i % 8; ++change) {
      bytes[random() % bytes.size()] = ",\n#\"1x\r-"[random() % 8];
    }
    try {
      (void)flight::Table::parse(tidied(bytes), "a.csv");
    } catch (const text::Error& error) {
      EXPECT_TRUE(std::string_view{error.what()}.starts_with("a.csv")) << error.what();
    }
  }
}

TEST(Load, KeepsTheLinesOfTheFile) {
  const test::Folder folder;
  const Loaded loaded = load(folder.write("a.csv", "# AltOS\n#time,x,x\n\n1,2,3\n"));
  EXPECT_EQ(loaded.table.place(0), "line 4");
  EXPECT_EQ(loaded.table.columns(), (std::vector<std::string>{"time", "x", "x.1"}));
}

TEST(Load, RefusesWhatIsNoLog) {
  const test::Folder folder;
  expect_refusal(text::ErrorKind::no_such_input, {"none.csv"}, [&] { (void)load(folder / "none.csv"); });
  expect_refusal(text::ErrorKind::bad_data, {"is empty"}, [&] { (void)load(folder.write("e.csv", "")); });
  for (const std::string ending : {".ftl", ".lcmlog"}) {
    expect_refusal(
        text::ErrorKind::bad_data,
        {"a" + ending, "listen reads no files that end in " + ending, "CSV (any other ending), .mat, .parquet"},
        [&] { (void)load(folder.write("a" + ending, "t,a\n1,2\n")); });
    expect_refusal(text::ErrorKind::no_such_input, {"none" + ending}, [&] { (void)load(folder / ("none" + ending)); });
  }
}

}  // namespace
}  // namespace fantail::listen
