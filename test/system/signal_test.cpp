// SPDX-License-Identifier: MIT
#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

#include "system/refusal.hpp"

namespace fantail::test {
namespace {

using namespace std::chrono_literals;

const std::vector<std::string> long_flight{"fly",   "tunnel_steps",           "--set", "timing.pad_time_s=600",
                                           "--set", "run.control_time_s=600", "--out", "result/new"};

// The number after a name in a file of /proc; empty when there is none.
std::optional<std::uint64_t> figure(int process, const char* file, const std::string& name, int base) {
  const std::string text = content("/proc/" + std::to_string(process) + "/" + file);
  const std::size_t at = text.find(name);
  return at == std::string::npos ? std::nullopt
                                 : std::optional{std::stoull(text.substr(at + name.size()), nullptr, base)};
}

// How busy the machine is must not decide a test, so these wait for what they need, and not for a time.
void wait_until_caught(int process, int signal) {
  const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(signal - 1);
  while ((figure(process, "status", "SigCgt:", 16).value_or(bit) & bit) == 0) {
    std::this_thread::sleep_for(1ms);
  }
}

void pause_for(int process, std::chrono::milliseconds time) {
  kill(process, SIGSTOP);
  std::this_thread::sleep_for(time);
  kill(process, SIGCONT);
}

class Signal : public testing::TestWithParam<int> {};

TEST_P(Signal, DuringALongRunEndsItWithNothingWritten) {
  const Folder folder;
  const auto interrupt = [](int process) {
    wait_until_caught(process, GetParam());
    std::this_thread::sleep_for(20ms);
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
    wait_until_caught(process, SIGTERM);
    kill(process, SIGHUP);
  };
  const Outcome outcome = fantail({"fly", "tunnel_steps", "--out", "out"},
                                  {.working_folder = folder.path(), .prepare = ignore, .meanwhile = hang_up});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST(Progress, IsShownOnATerminalForALongRunAndThenErased) {
  const Folder folder;
  std::atomic<bool> has_spoken = false;
  // On a fast machine the run would be over in half a second; one that never speaks must not be waited for forever.
  const auto slow_down_until_it_speaks_then_interrupt = [&](int process) {
    wait_until_caught(process, SIGHUP);  // the last one to be caught
    for (int pauses = 0; !has_spoken && pauses < 300; ++pauses) {
      pause_for(process, 100ms);
      std::this_thread::sleep_for(5ms);
    }
    kill(process, SIGINT);
  };
  const Outcome outcome = fantail(long_flight, {.working_folder = folder.path(),
                                                .meanwhile = slow_down_until_it_speaks_then_interrupt,
                                                .terminal = true,
                                                .has_spoken = &has_spoken});
  EXPECT_EQ(outcome.exit_code, 130);
  expect_said(outcome.err, {"flying tunnel_steps: ", "x real time", " to go", "\r\033[Kfantail: interrupted"});
}

TEST(Progress, OfWorkThatCannotSayHowFarItIsNamesThePart) {
  const Folder folder;
  ASSERT_EQ(fantail({"fly", "--out", "flight"}, {.working_folder = folder.path()}).exit_code, 0);
  std::atomic<bool> has_spoken = false;
  const auto slow_down_until_it_speaks = [&](int process) {
    wait_until_caught(process, SIGHUP);
    for (int pauses = 0; !has_spoken && pauses < 100; ++pauses) {
      pause_for(process, 100ms);
    }
  };
  const Outcome outcome = fantail({"log", "export", "flight", "--to", "ulog"}, {.working_folder = folder.path(),
                                                                                .meanwhile = slow_down_until_it_speaks,
                                                                                .terminal = true,
                                                                                .has_spoken = &has_spoken});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_said(outcome.err, {"log export: re", " (part ", " of 2), "});
}

TEST(Progress, IsSilentOnATerminalForWorkOfAMoment) {
  EXPECT_EQ(fantail({"plan", "show", "tunnel_steps"}, {.terminal = true}).err, "");
}

TEST(Progress, IsSilentInAPipe) {
  const Folder folder;
  const auto slow_down = [](int process) {
    wait_until_caught(process, SIGHUP);
    pause_for(process, 700ms);
  };
  const Outcome outcome =
      fantail({"fly", "tunnel_steps", "--out", "out"}, {.working_folder = folder.path(), .meanwhile = slow_down});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
}

}  // namespace
}  // namespace fantail::test
