// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "runs/runner.hpp"

namespace fantail::runs {
namespace {

const auto look_away = [](std::size_t) {};

TEST(ParallelFor, DoesEveryPieceOfWorkOnce) {
  for (const unsigned threads : {0U, 1U, 2U, 7U}) {
    std::array<std::atomic<int>, 50> done{};
    parallel_for(done.size(), threads, [&done](std::size_t i) { ++done[i]; }, look_away);
    for (const auto& times : done) {
      EXPECT_EQ(times, 1) << threads << " threads";
    }
  }
}

TEST(ParallelFor, TakesAtMostFourThreadsForEachProcessor) {
  std::mutex mutex;
  std::set<std::thread::id> seen;
  parallel_for(
      2000, 1000,
      [&](std::size_t) {
        const std::lock_guard lock{mutex};
        seen.insert(std::this_thread::get_id());
      },
      look_away);
  EXPECT_LE(seen.size(), std::size_t{4} * std::max(1U, std::thread::hardware_concurrency()));
}

TEST(ParallelFor, TellsTheCallerOnTheCallersThreadAndAtTheEndThatAllIsDone) {
  std::size_t last = 0;
  const auto caller = std::this_thread::get_id();
  parallel_for(
      5, 2, [](std::size_t) {},
      [&](std::size_t done) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        last = done;
      });
  EXPECT_EQ(last, 5U);
}

TEST(ParallelFor, NothingToDoIsDoneAtOnce) {
  parallel_for(0, 2, [](std::size_t) { FAIL(); }, look_away);
}

TEST(ParallelFor, TroubleInOnePieceEndsAllAndComesOut) {
  std::atomic<int> done{0};
  EXPECT_THROW(parallel_for(
                   100000, 2,
                   [&done](std::size_t i) {
                     ++done;
                     if (i == 3) {
                       throw std::runtime_error{"a wing fell off"};
                     }
                     // Long enough that the others cannot be through before they are told, however late that is.
                     std::this_thread::sleep_for(std::chrono::milliseconds{1});
                   },
                   look_away),
               std::runtime_error);
  EXPECT_LT(done, 100000);
}

// As when a person presses Ctrl-C: nobody goes on working after that.
TEST(ParallelFor, ACallerWhoGivesUpEndsAll) {
  std::atomic<bool> given_up{false};
  std::atomic<int> done{0};
  EXPECT_THROW(parallel_for(
                   1000000, 2,
                   [&](std::size_t) {
                     ++done;
                     while (!given_up) {
                       std::this_thread::yield();
                     }
                   },
                   [&given_up](std::size_t) {
                     given_up = true;
                     throw std::runtime_error{"enough"};
                   }),
               std::runtime_error);
  const int at_return = done;
  EXPECT_EQ(done, at_return);
}

}  // namespace
}  // namespace fantail::runs
