// SPDX-License-Identifier: MIT
#include "logs/load_table.hpp"

#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "logs/refused.hpp"
#include "logs/roll_log.hpp"
#include "system/folder.hpp"
#include "table_file/parquet_writer.hpp"
#include "table_file/tables.hpp"

namespace fantail::logs {
namespace {

using table_file::Columns;
using table_file::Kind;
using test::expect_refused;
using text::ErrorKind;

// Three ticks of a flight, and one to which no replay leads.
Columns flight() {
  return {{.name = "time_s", .values = {0.0, 0.25, 0.5, 0.75}},
          {.name = "phase", .kind = Kind::word, .values = {0, 1, 1, 1}, .words = {"launched", "controlling"}},
          {.name = "roll_angle_deg", .values = {0.0, 22.5, 45.0, table_file::unknown}},
          {.name = "roll_rate_deg_s", .values = {90.0, 90.0, 90.0, table_file::unknown}},
          {.name = "replayed", .kind = Kind::flag, .values = {1, 1, 1, 0}}};
}

class LoadTable : public testing::Test {
 protected:
  RollLog read(const std::string& name, const std::string& bytes) const {
    return read_roll_log(folder_.write(name, bytes), {}, {});
  }
  void expect_refusal(const std::string& name, const std::string& bytes,
                      std::initializer_list<const char*> words) const {
    expect_refused(ErrorKind::bad_data, words, [&] { (void)read(name, bytes); });
  }

  const test::Folder folder_;
};

TEST_F(LoadTable, AMatFileAndAParquetFileAreTheFlightThatACsvFileIs) {
  const std::string csv =
      "time_s,phase,roll_angle_deg,roll_rate_deg_s,replayed\n"
      "0,launched,0,90,1\n0.25,controlling,22.5,90,1\n0.5,controlling,45,90,1\n0.75,controlling,,,0\n";
  const RollLog wanted = read("log.csv", csv);
  ASSERT_EQ(wanted.time_s.size(), 3U);
  for (const RollLog& log : {read("log.mat", table_file::mat_file(flight())),
                             read("log.parquet", table_file::parquet::file(flight(), "{}"))}) {
    EXPECT_EQ(log.time_s, wanted.time_s);
    EXPECT_EQ(log.roll_angle_rad, wanted.roll_angle_rad);
    EXPECT_NEAR(log.roll_rate_rad_s.at(2), std::numbers::pi / 2.0, 1e-12);
    EXPECT_EQ(log.phase, wanted.phase);
    EXPECT_EQ(log.warnings, wanted.warnings);
  }
}

TEST_F(LoadTable, NamesTheRowOfWhatIsWrong) {
  Columns backwards = flight();
  backwards[0].values[2] = 0.1;
  expect_refusal("log.mat", table_file::mat_file(backwards), {"log.mat: row 3: time_s is 0.1 after 0.25 in row 2"});
  Columns without = flight();
  without[3].name = "p";
  expect_refusal("log.parquet", table_file::parquet::file(without, "{}"),
                 {"log.parquet: no column roll_rate_deg_s", "time_s, phase, roll_angle_deg, p"});
}

TEST_F(LoadTable, RefusesWhatIsDamagedAndWhatIsOnlyWritten) {
  const std::string whole = table_file::mat_file(flight());
  expect_refusal("log.mat", whole.substr(0, whole.size() - 1), {"log.mat", "ends within a variable"});
  expect_refusal("log.mat", "time_s,roll_angle_deg\n0,1\n", {"log.mat", "no MAT-file"});
  expect_refusal("log.parquet", whole, {"log.parquet: is no Parquet file"});
  for (const char* name : {"log.mcap", "log.ulg", "log.lcmlog", "log.json"}) {
    expect_refusal(name, "anything", {name, "allowed: .csv, .mat, .parquet and .ftl"});
  }
  expect_refused(ErrorKind::no_such_input, {"none.mat: no such file"},
                 [&] { (void)load_table(folder_.path() / "none.mat"); });
}

}  // namespace
}  // namespace fantail::logs
