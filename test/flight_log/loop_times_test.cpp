// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "flight_log/flight_figures.hpp"

namespace fantail::flight_log {
namespace {

using core::Microseconds;

Flight with_durations(const std::vector<int>& durations_us) {
  Flight flight;
  for (std::size_t i = 0; i < durations_us.size(); ++i) {
    flight.ticks.push_back({.sequence = static_cast<std::uint32_t>(i),
                            .tick = {.time = Microseconds{1'000} * static_cast<std::int64_t>(i),
                                     .duration_before = Microseconds{durations_us[i]}}});
  }
  return flight;
}

TEST(LoopTimes, MeanNinetyNinthPercentileAndLongest) {
  std::vector<int> durations(198, 100);
  durations.push_back(400);
  durations.push_back(1'000);
  const auto times = loop_times(with_durations(durations));
  ASSERT_TRUE(times.has_value());
  EXPECT_EQ(times->ticks, 200U);
  EXPECT_DOUBLE_EQ(times->mean_us, (198 * 100 + 400 + 1'000) / 200.0);
  EXPECT_EQ(times->p99_us, 100.0) << "198 of 200 are 99 %";
  EXPECT_EQ(times->longest_us, 1'000.0);
  EXPECT_EQ(times->late, 1U) << "a whole millisecond is too long";
  EXPECT_EQ(times->longest_step_us, 1'000.0);
}

TEST(LoopTimes, OneTickIsItsOwnPercentile) {
  const auto times = loop_times(with_durations({70}));
  ASSERT_TRUE(times.has_value());
  EXPECT_EQ(times->p99_us, 70.0);
  EXPECT_EQ(times->longest_step_us, 0.0);
}

TEST(LoopTimes, AStepOverLostRecordsIsNoLateTick) {
  Flight flight = with_durations({100, 100, 100, 100});
  flight.ticks[2].sequence += 5;
  flight.ticks[3].sequence += 5;
  flight.ticks[2].tick.time += Microseconds{5'000};
  flight.ticks[3].tick.time += Microseconds{6'200};
  flight.gaps.push_back({.first_missing = 2, .count = 5});
  EXPECT_EQ(loop_times(flight)->longest_step_us, 2'200.0);
}

TEST(LoopTimes, NoTickHasNone) { EXPECT_FALSE(loop_times(Flight{}).has_value()); }

}  // namespace
}  // namespace fantail::flight_log
