// SPDX-License-Identifier: MIT
#include "text/output_folder.hpp"

#include <csignal>
#include <cstdlib>
#include <fstream>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "test.hpp"

namespace fantail::text {
namespace {

namespace fs = std::filesystem;

class OutputFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "fantail_output_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string read(const fs::path& path) {
    std::ifstream in{path, std::ios::binary};
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  static std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator{folder}) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }
  static std::string failure(const fs::path& folder, std::span<const NamedFile> files) {
    try {
      OutputFolder{folder}.write(files);
    } catch (const OutputError& error) {
      return error.what();
    }
    return "no failure";
  }

  fs::path folder_;
};

const std::array<NamedFile, 3> first{{{"flight.csv", "one"}, {"summary.json", "two"}, {"report.html", "three"}}};
const std::array<NamedFile, 3> second{{{"flight.csv", "1"}, {"summary.json", "2"}, {"report.html", "3"}}};
const std::set<std::string> three_names{"flight.csv", "summary.json", "report.html"};

// Makes every file larger than a kilobyte fail with EFBIG, as a full disk would with ENOSPC.
class SmallFilesOnly {
 public:
  SmallFilesOnly() {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{1024, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFilesOnly() { setrlimit(RLIMIT_FSIZE, &before_); }
  SmallFilesOnly(const SmallFilesOnly&) = delete;
  SmallFilesOnly& operator=(const SmallFilesOnly&) = delete;

 private:
  rlimit before_{};
};

TEST_F(OutputFolderTest, WritesAllFilesAndMakesTheFoldersOnTheWay) {
  const fs::path deep = folder_ / "out" / "tasha3";
  OutputFolder{deep}.write(first);
  EXPECT_EQ(names_in(deep), three_names);
  EXPECT_EQ(read(deep / "flight.csv"), "one");
  EXPECT_EQ(read(deep / "report.html"), "three");
}

TEST_F(OutputFolderTest, ANewResultReplacesTheOldOneAndLeavesNothingBehind) {
  OutputFolder{folder_}.write(first);
  std::ofstream{folder_ / "mine.txt"} << "keep";
  OutputFolder{folder_}.write(second);
  EXPECT_EQ(names_in(folder_), (std::set<std::string>{"flight.csv", "summary.json", "report.html", "mine.txt"}));
  EXPECT_EQ(read(folder_ / "summary.json"), "2");
}

TEST_F(OutputFolderTest, FilesFollowTheUsersMask) {
  const mode_t before = umask(027);
  OutputFolder{folder_}.write(first);
  umask(before);
  struct stat info{};
  ASSERT_EQ(stat((folder_ / "flight.csv").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777U, 0640U);
}

TEST_F(OutputFolderTest, AFileThatDoesNotFitLeavesTheEarlierResultUntouched) {
  OutputFolder{folder_}.write(first);
  const std::array<NamedFile, 2> files{{{"flight.csv", "1"}, {"report.html", std::string(5000, 'x')}}};
  const SmallFilesOnly limit;
  EXPECT_EQ(failure(folder_, files), (folder_ / "report.html").string() + ": File too large");
  EXPECT_EQ(names_in(folder_), three_names);
  EXPECT_EQ(read(folder_ / "flight.csv"), "one");
}

TEST_F(OutputFolderTest, AFileThatDoesNotFitLeavesNoNewFolder) {
  const std::array<NamedFile, 1> files{{{"report.html", std::string(5000, 'x')}}};
  const SmallFilesOnly limit;
  EXPECT_NE(failure(folder_ / "a" / "b", files), "no failure");
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(OutputFolderTest, AFailureWhileNamingBringsTheEarlierResultBack) {
  OutputFolder{folder_}.write(first);
  fs::remove(folder_ / "report.html");
  fs::create_directories(folder_ / "report.html" / "in the way");  // the third rename cannot succeed
  EXPECT_EQ(failure(folder_, second), (folder_ / "report.html").string() + ": Is a directory");
  EXPECT_EQ(names_in(folder_), three_names);
  EXPECT_EQ(read(folder_ / "flight.csv"), "one");
  EXPECT_EQ(read(folder_ / "summary.json"), "two");
}

TEST_F(OutputFolderTest, AFileInPlaceOfTheFolderIsNamed) {
  std::ofstream{folder_ / "taken"} << "a file";
  EXPECT_EQ(failure(folder_ / "taken", first), (folder_ / "taken").string() + ": Not a directory");
  EXPECT_EQ(failure(folder_ / "taken" / "below", first).find((folder_ / "taken").string()), 0U);
  EXPECT_EQ(read(folder_ / "taken"), "a file");
}

TEST_F(OutputFolderTest, AnUnwritableFolderIsNamed) {
  // Nobody can create files here, root included.
  EXPECT_EQ(failure("/proc/self", first).find("/proc/self/flight.csv: "), 0U);
  if (geteuid() != 0) {
    fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_EQ(failure(folder_, first), (folder_ / "flight.csv").string() + ": Permission denied");
    fs::permissions(folder_, fs::perms::owner_all);
  }
}

TEST_F(OutputFolderTest, WhatIsNoFileIsNotReplacedByOne) {
  fs::create_directory(folder_);
  ASSERT_EQ(mkfifo((folder_ / "flight.csv").c_str(), 0600), 0);
  EXPECT_EQ(failure(folder_, first),
            (folder_ / "flight.csv").string() + ": is a device, a pipe or a socket, so no file can be written there");
  EXPECT_TRUE(fs::is_fifo(folder_ / "flight.csv"));
  EXPECT_EQ(names_in(folder_), std::set<std::string>{"flight.csv"});
}

TEST_F(OutputFolderTest, TheFileSizeSignalIsHandedBack) {
  const auto handler = [](int) {};
  const auto before = std::signal(SIGXFSZ, handler);
  OutputFolder{folder_}.write(first);
  EXPECT_EQ(std::signal(SIGXFSZ, before), static_cast<void (*)(int)>(handler));
}

TEST_F(OutputFolderTest, WhatIsToBeRemovedIsGoneAfterwardsAndOnlyThen) {
  const std::array<std::string, 2> removed{"flight.ftl", "tunnel.csv"};
  const std::array<NamedFile, 4> with_log{
      {{"flight.csv", "one"}, {"summary.json", "two"}, {"report.html", "three"}, {"flight.ftl", "four"}}};
  OutputFolder{folder_}.write(with_log);
  OutputFolder{folder_}.write(second, removed);
  EXPECT_EQ(names_in(folder_), three_names);

  OutputFolder{folder_}.write(with_log);
  fs::create_directory(folder_ / "tunnel.csv");  // of nobody's run: it stays
  OutputFolder{folder_}.write(second, removed);
  EXPECT_TRUE(fs::exists(folder_ / "tunnel.csv"));
  EXPECT_FALSE(fs::exists(folder_ / "flight.ftl"));
}

TEST_F(OutputFolderTest, AFailureBringsBackWhatWasToBeRemoved) {
  const std::array<std::string, 1> removed{"flight.ftl"};
  const std::array<NamedFile, 1> log{{{"flight.ftl", "four"}}};
  OutputFolder{folder_}.write(log);
  fs::create_directory(folder_ / "report.html");
  const std::array<NamedFile, 1> page{{{"report.html", "three"}}};
  EXPECT_THROW(OutputFolder{folder_}.write(page, removed), OutputError);
  EXPECT_EQ(read(folder_ / "flight.ftl"), "four");
}

TEST_F(OutputFolderTest, WhatTheResultsAreMadeFromIsNeitherReplacedNorRemovedNorWrittenInto) {
  OutputFolder{folder_}.write(first);
  fs::create_hard_link(folder_ / "flight.csv", folder_ / "another_name.csv");
  const std::array<NamedFile, 1> page{{{"page.html", "new"}}};
  const std::array<std::string, 1> csv{"flight.csv"};
  const std::vector<fs::path> inputs{folder_ / "another_name.csv"};
  EXPECT_THROW(OutputFolder(folder_, inputs).write(second), OutputError);
  EXPECT_THROW(OutputFolder(folder_, inputs).write(page, csv), OutputError);
  EXPECT_THROW(OutputFolder(folder_, {folder_}).write(page), OutputError);
  EXPECT_EQ(read(folder_ / "flight.csv"), "one");
  EXPECT_FALSE(fs::exists(folder_ / "page.html"));
  OutputFolder(folder_, inputs).write(page);
  EXPECT_EQ(read(folder_ / "page.html"), "new");
  OutputFolder(folder_ / "apart", {folder_, folder_ / "no such file"}).write(page);
}

}  // namespace
}  // namespace fantail::text
