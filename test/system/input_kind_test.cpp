// SPDX-License-Identifier: MIT
// What is no file, or no end of one, in the place of a file.
#include <algorithm>
#include <atomic>
#include <cctype>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>

#include <sys/resource.h>
#include <sys/stat.h>

#include "json/value.hpp"
#include "refusal.hpp"
#include "system/folder.hpp"
#include "text/deflate.hpp"

namespace fantail::test {
namespace {

using namespace std::chrono_literals;

const std::vector<Words> readers{{"log", "info", "pipe.ftl"},
                                 {"log", "export", "pipe.ftl", "--to", "csv"},
                                 {"replay", "pipe.ftl"},
                                 {"report", "pipe.ftl"},
                                 {"report", "pipe.csv"},
                                 {"listen", "pipe.csv"},
                                 {"listen", "pipe.ulg"},
                                 {"identify", "pipe.csv", "--vehicle", "tasha3_launch2"},
                                 {"tunnel", "steps", "pipe.csv", "--vehicle", "tasha3_launch2"},
                                 {"tunnel", "flow", "pipe.csv"},
                                 {"compare", "pipe.csv", "pipe.csv"},
                                 {"fly", "--trajectory", "pipe.csv"}};

std::string joined(const Words& words) {
  std::string all;
  for (const std::string& word : words) {
    all += (all.empty() ? "" : " ") + word;
  }
  return all;
}

bool has_opened_a_pipe(int process) {
  std::error_code gone;
  const auto files = std::filesystem::directory_iterator{"/proc/" + std::to_string(process) + "/fd", gone};
  return std::any_of(begin(files), end(files), [](const auto& file) {
    std::error_code ignored;
    return std::filesystem::read_symlink(file.path(), ignored).stem() == "pipe";
  });
}

class AVerbThatWaitsForAPipe : public testing::TestWithParam<Words> {};

TEST_P(AVerbThatWaitsForAPipe, EndsAtOnceWithBothSignals) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Folder folder;
    for (const char* name : {"pipe.ftl", "pipe.csv", "pipe.ulg"}) {
      ASSERT_EQ(::mkfifo((folder / name).c_str(), 0600), 0);
    }
    const Words before = folder.listing();
    auto begin = std::chrono::steady_clock::now();
    const auto interrupt = [&](int process) {
      for (int i = 0; i < 2'000 && !has_opened_a_pipe(process); ++i) {
        std::this_thread::sleep_for(10ms);
      }
      begin = std::chrono::steady_clock::now();
      kill(process, signal);
    };
    const Outcome outcome = fantail(GetParam(), {.working_folder = folder.path(), .meanwhile = interrupt});
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
    EXPECT_EQ(outcome.exit_code, 130) << "signal " << outcome.signal << outcome.err;
    EXPECT_EQ(outcome.err, "fantail: interrupted; nothing was written\n");
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder.listing(), before);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, AVerbThatWaitsForAPipe, testing::ValuesIn(readers), [](const auto& one) {
  std::string name = joined(one.param);
  std::ranges::replace_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

TEST(Input, OfAPipeThatNobodyWritesToIsWaitedForAloud) {
  const Folder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe.ftl").c_str(), 0600), 0);
  std::atomic<bool> has_spoken = false;
  const auto interrupt = [&](int process) {
    for (int i = 0; i < 3'000 && !has_spoken; ++i) {
      std::this_thread::sleep_for(10ms);
    }
    kill(process, SIGINT);
  };
  const Outcome outcome = fantail({"replay", "pipe.ftl"},
                                  {.working_folder = folder.path(), .meanwhile = interrupt, .has_spoken = &has_spoken});
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.err,
            "pipe.ftl is a pipe that has given no data for 5 s; Ctrl-C ends the wait\n"
            "fantail: interrupted; nothing was written\n");
}

TEST(Input, OfAPipeIsWhatComesThroughIt) {
  const Folder folder;
  ASSERT_EQ(fantail({"fly", "--out", folder / "flight"}).exit_code, 0);
  const Outcome file = run("sh", {"-c", "\"$0\" log info \"$1\" --json", fantail_path(), folder / "flight/flight.ftl"});
  const Outcome piped =
      run("bash", {"-c", "\"$0\" log info <(cat \"$1\") --json", fantail_path(), folder / "flight/flight.ftl"});
  EXPECT_EQ(piped.exit_code, 0) << piped.err;
  EXPECT_EQ(json::parse(piped.out)["flights"].pretty(), json::parse(file.out)["flights"].pretty());
}

TEST(Input, ThatIsADeviceAFolderOrFarTooLargeIsRefusedInWords) {
  for (const char* place : {"x.csv", "x.ftl", "x.ulg", "x.mat", "x.parquet"}) {
    const Folder folder;
    std::filesystem::create_symlink("/dev/zero", folder.path() / place);
    const std::string verb = std::string{place}.ends_with(".ftl") ? "replay" : "listen";
    const Outcome device = fantail({verb, place}, {.working_folder = folder.path()});
    EXPECT_EQ(device.exit_code, 66) << device.err;
    EXPECT_EQ(device.err,
              "fantail: " + std::string{place} + ": is a device, not a file; copy the data you need into a file\n");
    std::filesystem::remove(folder.path() / place);
    folder.write(place, "");
    std::filesystem::resize_file(folder.path() / place, std::uintmax_t{1} << 40U);
    const Outcome large = fantail({verb, place}, {.working_folder = folder.path()});
    EXPECT_EQ(large.exit_code, 65) << large.err;
    EXPECT_NE(large.err.find("larger than 512 MiB, the most that is read of one file"), std::string::npos) << large.err;
  }
}

TEST(Input, ThatAPersonWritesIsNoDeviceNoFolderAndNoGigabyte) {
  const Folder folder;
  folder.write("large.toml", "");
  std::filesystem::resize_file(folder.path() / "large.toml", std::uintmax_t{1} << 33U);
  folder.write("large.eng", "");
  std::filesystem::resize_file(folder.path() / "large.eng", std::uintmax_t{1} << 33U);
  for (const Words& words : {Words{"fly", "large.toml"},
                             {"plan", "check", "large.toml"},
                             {"airframe", "large.toml"},
                             {"new", "x", "--from", "tasha3_launch2", "--motor", "large.eng"}}) {
    const Outcome outcome = fantail(words, {.working_folder = folder.path()});
    EXPECT_EQ(outcome.exit_code, 65) << joined(words) << outcome.err;
    EXPECT_NE(outcome.err.find("larger than 16 MiB, which is too large"), std::string::npos) << outcome.err;
  }
}

// Some 60 kB that become 60 MB, where one run is a few hundred bytes.
TEST(Input, ThatIsABombIsRefusedWhereItIsUnpacked) {
  const Folder folder;
  const std::string bomb = text::gzip(std::string(60U << 20U, ' '));
  ASSERT_EQ(
      fantail({"campaign", "tasha3_launch2", "--runs", "1", "--shard", "1/1", "--out", folder / "part"}).exit_code, 0);
  folder.write("part/runs.csv.gz", bomb);
  const Outcome outcome = fantail({"campaign", "merge", folder / "part", "--out", folder / "whole"});
  EXPECT_EQ(outcome.exit_code, 65) << outcome.err;
  EXPECT_NE(outcome.err.find("is damaged, not complete, or longer than its runs are"), std::string::npos)
      << outcome.err;
}

TEST(Input, ThatTheMemoryHasNoRoomForIsSaidSo) {
  const Folder folder;
  folder.write("log.csv", "time_s,roll_rate_deg_s\n");
  std::filesystem::resize_file(folder.path() / "log.csv", 500U << 20U);
  const auto little_memory = [] {
    const rlimit limit{.rlim_cur = 300U << 20U, .rlim_max = 300U << 20U};
    setrlimit(RLIMIT_AS, &limit);
  };
  const Outcome outcome = fantail({"listen", "log.csv"}, {.working_folder = folder.path(), .prepare = little_memory});
  EXPECT_EQ(outcome.exit_code, 70) << outcome.err;
  EXPECT_EQ(outcome.err, "fantail: not enough memory; end other programs, or give less data at once\n");
}

}  // namespace
}  // namespace fantail::test
