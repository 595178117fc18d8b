// SPDX-License-Identifier: MIT
#include "logs/load_table.hpp"

#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "flight/units.hpp"
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

std::string mat_file_with_units(const std::string& angle_name, const std::string& angle_unit) {
  const std::vector<double> time_s{0.0, 0.25};
  const std::vector<double> values{0.0, 1.0};
  const std::vector<table_file::mat::Member> columns{{"time_s", {table_file::mat::column(time_s)}},
                                                     {angle_name, {table_file::mat::column(values)}},
                                                     {"roll_rate_deg_s", {table_file::mat::column(values)}}};
  const std::vector<table_file::mat::Member> units{{"time_s", {table_file::mat::text("s")}},
                                                   {angle_name, {table_file::mat::text(angle_unit)}}};
  return table_file::mat::file(
      std::vector{table_file::mat::structs(1, columns, "flight"), table_file::mat::structs(1, units, "units")});
}

TEST_F(LoadTable, RefusesAMatFileThatSaysAnotherUnitThanItIsReadIn) {
  const std::filesystem::path file = folder_.write("log.mat", mat_file_with_units("roll_angle_deg", "rad"));
  expect_refused(ErrorKind::bad_data, {"log.mat: units.roll_angle_deg is rad, and roll_angle_deg is read in deg"},
                 [&] { (void)read_roll_log(file, {}, {}); });
  const flight::Reading stated{.columns = {{"roll_angle_deg", "roll_angle_deg"}},
                               .units = {{"roll_angle_deg", *flight::find_unit("rad")}}};
  EXPECT_EQ(read_roll_log(file, stated, {}).roll_angle_rad, (std::vector{0.0, 1.0}));
  const flight::Reading radians{.angles = flight::AngleUnit::radians};
  EXPECT_EQ(read_roll_log(file, radians, {}).roll_angle_rad, (std::vector{0.0, 1.0}));
  (void)folder_.write("log.mat", mat_file_with_units("roll_angle_rad", "deg"));
  expect_refused(ErrorKind::bad_data, {"units.roll_angle_rad is deg, and roll_angle_rad is read in rad"},
                 [&] { (void)read_roll_log(file, radians, {}); });
  EXPECT_EQ(read("same.mat", mat_file_with_units("roll_angle_deg", "deg")).time_s.size(), 2U);
}

TEST_F(LoadTable, RefusesAMatFileWithAWantedNameThatIsNoColumn) {
  using table_file::mat::column;
  const std::vector<double> values{0.0, 0.25};
  const auto file = [&](const std::string& name) {
    return table_file::mat::file(std::vector{column(values, "time_s"), column(values, "roll_rate_deg_s"),
                                             table_file::mat::cell(std::vector{column(values), column(values)}, name)});
  };
  EXPECT_EQ(read("other.mat", file("parts")).time_s, values) << "nobody asks for it";
  expect_refusal("angle.mat", file("roll_angle_deg"), {"angle.mat: roll_angle_deg is a cell with something else"});
  const std::filesystem::path mapped = folder_.write("phi.mat", file("phi"));
  expect_refused(ErrorKind::bad_data, {"phi.mat: phi is a cell with something else than texts"},
                 [&] { (void)read_roll_log(mapped, {.columns = {{"roll_angle_deg", "phi"}}}, {}); });
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
                 [&] { (void)load_table(folder_.path() / "none.mat", {}); });
}

}  // namespace
}  // namespace fantail::logs
