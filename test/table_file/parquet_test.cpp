// SPDX-License-Identifier: MIT
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "logs/refused.hpp"
#include "table_file/parquet_writer.hpp"
#include "table_file/read.hpp"
#include "table_file/tables.hpp"

namespace fantail::table_file {
namespace {

using test::expect_refused;
using text::ErrorKind;

Columns read_shipped(const std::string& name) {
  std::ostringstream bytes;
  bytes << std::ifstream{FANTAIL_TABLES "/" + name, std::ios::binary}.rdbuf();
  return read_parquet(bytes.str(), name);
}

TEST(Parquet, GivesEveryKindOfColumnBack) {
  EXPECT_TRUE(same(read_parquet(parquet::file(small_table(), "{}"), "log.parquet"), small_table()));
}

TEST(Parquet, OfAColumnOfWhichNothingIsKnownAndOfNoRowsIsATable) {
  const Columns columns{{.name = "time_s", .values = {}}};
  EXPECT_TRUE(same(read_parquet(parquet::file(columns, "{}"), "log.parquet"), columns));
  const Columns empty{{.name = "speed_m_s", .values = std::vector<double>(1000, unknown)}};
  EXPECT_TRUE(same(read_parquet(parquet::file(empty, "{}"), "log.parquet"), empty));
}

// Two groups of rows, values that are missing and values that cannot be, as pyarrow writes them.
TEST(Parquet, OfPyarrowIsReadWhereItIsPlain) {
  const Columns wanted{
      {.name = "time_s", .values = {0.0, 0.25, 0.5, 0.75, 1.0}},
      {.name = "single", .values = {1.5, unknown, -2.5, unknown, unknown}},
      {.name = "unsigned", .kind = Kind::integer, .values = {1, 2, 4294967295.0, unknown, 0}},
      {.name = "long", .kind = Kind::integer, .values = {-1, 2, unknown, 9007199254740992.0, 0}},
      {.name = "flag", .kind = Kind::flag, .values = {1, unknown, 0, 1, 1}},
      {.name = "phase", .kind = Kind::word, .values = {0, 1, unknown, 1, 0}, .words = {"armed", "launched"}}};
  EXPECT_TRUE(same(read_shipped("pyarrow_plain.parquet"), wanted));
}

TEST(Parquet, InAnotherFormIsRefusedWithWhatToDo) {
  expect_refused(ErrorKind::bad_data,
                 {"pyarrow_snappy.parquet: time_s is packed by other means than gzip", "compression=\"gzip\"",
                  "use_dictionary=False"},
                 [] { (void)read_shipped("pyarrow_snappy.parquet"); });
  expect_refused(ErrorKind::bad_data, {"time_s is encoded by a dictionary", "use_dictionary=False"},
                 [] { (void)read_shipped("pyarrow_dictionary.parquet"); });
  expect_refused(ErrorKind::bad_data, {"log.parquet: is no Parquet file"},
                 [] { (void)read_parquet("time_s\n0\n", "log.parquet"); });
  expect_refused(ErrorKind::bad_data, {"its end is missing"}, [] { (void)read_parquet("PAR1", "log.parquet"); });
}

}  // namespace
}  // namespace fantail::table_file
