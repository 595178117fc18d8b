// SPDX-License-Identifier: MIT
#include "hal/linux/clock.hpp"

#include <chrono>
#include <thread>

#include "test.hpp"

namespace fantail::test {
namespace {

using hal::on_linux::Clock;

TEST(LinuxClock, StartsAtZeroAndRunsWithTheMonotonicClock) {
  const auto before = std::chrono::steady_clock::now();
  const Clock clock;
  std::this_thread::sleep_for(std::chrono::milliseconds{20});
  const auto now = clock.now();
  EXPECT_GE(now, std::chrono::milliseconds{20});
  EXPECT_LE(now, std::chrono::steady_clock::now() - before);
}

TEST(LinuxClock, NeverGoesBackwards) {
  const Clock clock;
  auto last = clock.now();
  for (int i = 0; i < 100'000; ++i) {
    const auto now = clock.now();
    ASSERT_GE(now, last);
    last = now;
  }
}

}  // namespace
}  // namespace fantail::test
