// SPDX-License-Identifier: MIT
#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>

#include "system/folder.hpp"
#include "system/process.hpp"

namespace fantail::test {
namespace {

using namespace std::chrono_literals;

const std::vector<std::string> long_flight{"fly",   "tunnel_steps",           "--set", "timing.pad_time_s=600",
                                           "--set", "run.control_time_s=600", "--out", "result/new"};

class Signal : public testing::TestWithParam<int> {};

TEST_P(Signal, DuringALongRunEndsItWithNothingWritten) {
  const Folder folder;
  const auto interrupt = [](int process) {
    std::this_thread::sleep_for(300ms);
    kill(process, GetParam());
  };
  const Outcome outcome = fantail(long_flight, {.working_folder = folder.path(), .meanwhile = interrupt});
  EXPECT_EQ(outcome.exit_code, 130) << "signal " << outcome.signal;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "fantail: interrupted; nothing was written\n");
  EXPECT_TRUE(folder.listing().empty());
}

INSTANTIATE_TEST_SUITE_P(Each, Signal, testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& one) { return std::string{sigabbrev_np(one.param)}; });

// nohup and background jobs of a shell ignore these from the start; the program must not undo that.
TEST(Signal, ThatWasIgnoredFromTheStartStaysIgnored) {
  const Folder folder;
  const auto ignore = [] { std::signal(SIGHUP, SIG_IGN); };
  const auto hang_up = [](int process) {
    std::this_thread::sleep_for(50ms);
    kill(process, SIGHUP);
  };
  const Outcome outcome = fantail({"fly", "tunnel_steps", "--out", "out"},
                                  {.working_folder = folder.path(), .prepare = ignore, .meanwhile = hang_up});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST(Progress, IsShownOnATerminalForALongRunAndThenErased) {
  const Folder folder;
  const auto interrupt = [](int process) {
    std::this_thread::sleep_for(1200ms);
    kill(process, SIGINT);
  };
  const Outcome outcome =
      fantail(long_flight, {.working_folder = folder.path(), .meanwhile = interrupt, .terminal = true});
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_NE(outcome.err.find("flying tunnel_steps: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("x real time"), std::string::npos);
  EXPECT_NE(outcome.err.find(" s to go"), std::string::npos);
  EXPECT_NE(outcome.err.find("\r\033[Kfantail: interrupted"), std::string::npos) << "the line is left standing";
}

TEST(Progress, IsSilentOnATerminalForAShortRun) {
  const Folder folder;
  const Outcome outcome = fantail({"plan", "show", "tunnel_steps"}, {.terminal = true});
  EXPECT_EQ(outcome.err, "");
}

TEST(Progress, IsSilentInAPipe) {
  const Folder folder;
  const auto interrupt = [](int process) {
    std::this_thread::sleep_for(1200ms);
    kill(process, SIGINT);
  };
  const Outcome outcome = fantail(long_flight, {.working_folder = folder.path(), .meanwhile = interrupt});
  EXPECT_EQ(outcome.err, "fantail: interrupted; nothing was written\n");
}

}  // namespace
}  // namespace fantail::test
