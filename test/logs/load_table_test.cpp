// SPDX-License-Identifier: MIT
// What is read of files of other programs is tested with the packages that read them: test/files.
#include "logs/load_table.hpp"

#include <string>

#include <gtest/gtest.h>

#include "logs/refused.hpp"
#include "system/folder.hpp"

namespace fantail::logs {
namespace {

using test::expect_refused;
using text::ErrorKind;

TEST(LoadTable, RefusesWhatIsOnlyWritten) {
  const test::Folder folder;
  for (const char* name : {"log.lcmlog", "log.json"}) {
    expect_refused(ErrorKind::bad_data, {name, "allowed: .csv, .ftl, .mat, .parquet"},
                   [&] { (void)load_table(folder.write(name, "anything"), {}); });
  }
  for (const char* name : {"none.csv", "none.mat", "none.json"}) {
    expect_refused(ErrorKind::no_such_input, {name, "no such file"},
                   [&] { (void)load_table(folder.path() / name, {}); });
  }
}

}  // namespace
}  // namespace fantail::logs
