// SPDX-License-Identifier: MIT
// Several writers of one folder: threads have one process id, and so may processes of two containers.
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "test.hpp"
#include "text/output_folder.hpp"

namespace fantail::text {
namespace {

namespace fs = std::filesystem;

class OutputFolderAtOnce : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "fantail_at_once_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// What all files of a result say, or why it is none.
  [[nodiscard]] static std::string result_in(const fs::path& folder) {
    std::set<std::string> contents;
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator{folder}) {
      std::ostringstream text;
      text << std::ifstream{entry.path(), std::ios::binary}.rdbuf();
      contents.insert(text.str());
      names.insert(entry.path().filename().string());
    }
    if (names != std::set<std::string>{"flight.csv", "flight.ftl", "report.html", "summary.json"}) {
      std::string list = "files:";
      for (const std::string& name : names) {
        list += " " + name;
      }
      return list;
    }
    return contents.size() == 1 ? *contents.begin() : "a mixture";
  }

  static void write_result(const fs::path& folder, const std::string& who) {
    OutputFolder{folder}.write(std::array<NamedFile, 4>{
        {{"flight.csv", who}, {"flight.ftl", who}, {"report.html", who}, {"summary.json", who}}});
  }

  fs::path folder_;
};

TEST_F(OutputFolderAtOnce, ThreadsThatWriteTheSameFolderLeaveTheWholeResultOfOne) {
  constexpr int rounds = 12;
  constexpr int threads = 6;
  for (int round = 0; round < rounds; ++round) {
    const fs::path folder = folder_ / std::to_string(round);
    std::atomic<int> failures = 0;
    std::vector<std::thread> writers;
    for (int i = 0; i < threads; ++i) {
      writers.emplace_back([&, i] {
        try {
          write_result(folder, std::string(2000, static_cast<char>('a' + i)));
        } catch (const OutputError&) {
          ++failures;
        }
      });
    }
    std::ranges::for_each(writers, &std::thread::join);
    EXPECT_EQ(failures, 0) << "round " << round;
    const std::string found = result_in(folder);
    EXPECT_EQ(found, std::string(2000, found.front())) << "round " << round;
  }
}

TEST_F(OutputFolderAtOnce, ProcessesThatWriteTheSameFolderLeaveTheWholeResultOfOne) {
  constexpr int rounds = 5;
  constexpr int processes = 6;
  for (int round = 0; round < rounds; ++round) {
    const fs::path folder = folder_ / std::to_string(round);
    for (int i = 0; i < processes; ++i) {
      if (fork() == 0) {
        int code = 0;
        try {
          for (int again = 0; again < 8; ++again) {
            write_result(folder, std::string(2000, static_cast<char>('a' + i)));
          }
        } catch (const OutputError&) {
          code = 1;
        }
        _exit(code);
      }
    }
    for (int i = 0; i < processes; ++i) {
      int status = 0;
      ASSERT_GT(wait(&status), 0);
      EXPECT_EQ(status, 0) << "round " << round;
    }
    const std::string found = result_in(folder);
    EXPECT_EQ(found, std::string(2000, found.front())) << "round " << round;
  }
}

// One fails and takes back the folders that it has made, while the other is about to write into them.
TEST_F(OutputFolderAtOnce, AWriterThatFailsTakesNothingAwayFromAnother) {
  constexpr int rounds = 60;
  for (int round = 0; round < rounds; ++round) {
    const fs::path folder = folder_ / std::to_string(round) / "deeper";
    std::atomic<int> failures = 0;
    std::thread bad{[&] {
      try {
        OutputFolder{folder}.write(std::array<NamedFile, 1>{{{"no such folder/x", "x"}}});
      } catch (const OutputError&) {
        ++failures;
      }
    }};
    std::thread good{[&] { EXPECT_NO_THROW(write_result(folder, "good")); }};
    bad.join();
    good.join();
    EXPECT_EQ(failures, 1);
    EXPECT_EQ(result_in(folder), "good") << "round " << round;
  }
}

TEST_F(OutputFolderAtOnce, NobodyWaitsForeverForAnotherAndNothingIsWrittenThen) {
  FolderLock held;
  ASSERT_TRUE(held.take(folder_, std::chrono::milliseconds{20}));
  FolderLock lock;
  try {
    (void)lock.take(folder_, std::chrono::milliseconds{20});
    ADD_FAILURE() << "taken";
  } catch (const OutputError& error) {
    EXPECT_NE(std::string{error.what()}.find("another program has been writing there for"), std::string::npos);
  }
  held.release();
  EXPECT_TRUE(lock.take(folder_, std::chrono::milliseconds{20}));
  lock.release();
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(OutputFolderAtOnce, AFolderThatHasGoneIsNotHeld) {
  FolderLock lock;
  EXPECT_FALSE(lock.take(folder_ / "gone", std::chrono::milliseconds{20}));
}

// Whoever was killed leaves the file, but not the lock.
TEST_F(OutputFolderAtOnce, AWriterThatWasKilledHoldsNobodyUp) {
  std::ofstream{folder_ / ".fantail.writing"} << "";
  write_result(folder_, "good");
  EXPECT_EQ(result_in(folder_), "good");
}

// The limit is that of the process, the signal that of the thread that meets it.
TEST_F(OutputFolderAtOnce, AFileSizeLimitEndsNoThread) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{1024, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  std::atomic<int> refused = 0;
  std::vector<std::thread> writers;
  constexpr int threads = 4;
  constexpr int rounds = 10;
  for (int i = 0; i < threads; ++i) {
    writers.emplace_back([&, i] {
      for (int round = 0; round < rounds; ++round) {
        try {
          OutputFolder{folder_ / std::to_string(i)}.write(
              std::array<NamedFile, 1>{{{"flight.csv", std::string(5000, 'x')}}});
        } catch (const OutputError&) {
          ++refused;
        }
      }
    });
  }
  std::ranges::for_each(writers, &std::thread::join);
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(refused, threads * rounds);
}

}  // namespace
}  // namespace fantail::text
