// SPDX-License-Identifier: MIT
#include "files/convert.hpp"

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "logs/refused.hpp"
#include "system/folder.hpp"

namespace fantail::files {
namespace {

using test::expect_refused;
using text::ErrorKind;

/// In place of Python a script of the shell: what is done with its answers, without Python's packages.
class Convert : public testing::Test {
 protected:
  Convert() : before_{std::getenv("FANTAIL_PYTHON")} {}
  ~Convert() override {
    before_ == nullptr ? ::unsetenv("FANTAIL_PYTHON") : ::setenv("FANTAIL_PYTHON", was_.c_str(), 1);
  }

  void python_is(const std::string& script) const {
    const std::string path = folder_.write("python", "#!/bin/sh\n" + script);
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    ::setenv("FANTAIL_PYTHON", path.c_str(), 1);
  }
  [[nodiscard]] std::string file(const std::string& name) const { return folder_.write(name, "content"); }

  const test::Folder folder_;

 private:
  const char* before_;
  std::string was_ = before_ == nullptr ? "" : before_;
};

TEST_F(Convert, GivesTheFileToPythonAndItsAnswerBack) {
  python_is(
      R"(echo '{"units": {"t": "s"}, "not_columns": {"z": "complex numbers"}, "notes": ["One."]}'; echo "$4"; cat)");
  const Read read = files::read(file("a.mat"));
  EXPECT_EQ(read.csv, ".mat\ncontent");
  EXPECT_EQ(read.units, (Read::Pairs{{"t", "s"}}));
  EXPECT_EQ(read.not_columns, (Read::Pairs{{"z", "complex numbers"}}));
  EXPECT_EQ(read.notes, std::vector<std::string>{"One."});
}

TEST_F(Convert, RefusesWhatPythonRefusesWithTheNameOfTheFile) {
  python_is("echo 'is no Parquet file' >&2; exit 65");
  expect_refused(ErrorKind::bad_data, {"a.parquet: is no Parquet file"}, [&] { (void)files::read(file("a.parquet")); });
  python_is("kill -SEGV $$");
  expect_refused(ErrorKind::bad_data, {"a.parquet: its reader ended with signal 11"},
                 [&] { (void)files::read(file("a.parquet")); });
  python_is("echo Traceback >&2; echo 'SyntaxError: x' >&2; exit 1");
  expect_refused(ErrorKind::bad_data, {"a.parquet: Python could not read or write it: SyntaxError: x"},
                 [&] { (void)files::read(file("a.parquet")); });
  expect_refused(ErrorKind::no_such_input, {"none.mat: no such file"},
                 [&] { (void)files::read(folder_.path() / "none.mat"); });
}

std::string what_is_missing(const std::string& file) {
  try {
    (void)files::read(file);
  } catch (const NotInstalled& error) {
    return error.what();
  }
  return "nothing";
}

TEST_F(Convert, NamesWhatIsMissingAndTheCommandThatInstallsIt) {
  python_is("echo pyarrow >&2; exit 69");
  const std::string said = what_is_missing(file("a.parquet"));
  EXPECT_NE(said.find("a.parquet: Python lacks pyarrow"), std::string::npos) << said;
  EXPECT_NE(said.find("/python -m pip install -r "), std::string::npos) << said;
  EXPECT_NE(said.find("/files/requirements.txt"), std::string::npos) << said;
  ::setenv("FANTAIL_PYTHON", "/nowhere/python", 1);
  EXPECT_NE(what_is_missing(file("a.parquet")).find("/nowhere/python cannot be started"), std::string::npos);
}

TEST_F(Convert, GivesNoNameToAShell) {
  python_is(R"(echo '{"units": {}, "not_columns": {}, "notes": []}'; printf '%s,' "$@")");
  const std::string name = "$(touch made) `touch made`;touch made;.mat";
  EXPECT_NE(files::read(file(name)).csv.find("__main__.py,read,.mat,"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "made"));
  EXPECT_FALSE(std::filesystem::exists("made"));
}

TEST_F(Convert, KnowsFilesByTheEndsOfTheirNames) {
  EXPECT_TRUE(is_read("a/b.mat"));
  EXPECT_TRUE(is_read("b.csv.gz"));
  EXPECT_FALSE(is_read("b.csv"));
  EXPECT_FALSE(is_read("b.ftl"));
  EXPECT_FALSE(is_read("parquet"));
}

}  // namespace
}  // namespace fantail::files
