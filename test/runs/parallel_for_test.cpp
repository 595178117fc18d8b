// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <set>
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

}  // namespace
}  // namespace fantail::runs
