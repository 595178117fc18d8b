// SPDX-License-Identifier: MIT
// What a record says of the board beside the flight.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "recorder_rig.hpp"

namespace fantail::avionics {
namespace {

using core::Phase;
using protocol::LogEventKind;

struct RecordedBoard : testing::Test {
  hal::sim::Flash flash{one_mib};
  RecorderRig rig{flash};
  [[nodiscard]] std::span<const std::byte> log() { return region_of(flash); }
};

TEST_F(RecordedBoard, TellsHowManyCyclesALongerTickTookThanAllOfTheFlightBeforeIt) {
  rig.run(Phase::armed, 1000);
  rig.board.cycles = 99'000;  // on the pad
  rig.run(Phase::launched, 100);
  for (const std::uint32_t cycles : {30'000U, 20'000U, 50'000U}) {
    rig.board.cycles = cycles;
    rig.run(Phase::launched, 100);
  }
  rig.settle(Phase::armed);
  std::vector<std::uint32_t> told;
  for (const protocol::LogEvent& event : events_in(log())) {
    if (event.kind == LogEventKind::longest_tick) {
      told.push_back(event.number);
    }
  }
  EXPECT_EQ(told, (std::vector<std::uint32_t>{30'000, 50'000}));
}

TEST_F(RecordedBoard, TellsEveryFaultOfTheBoardThatComesOrGoes) {
  rig.run(Phase::armed, 1000);
  rig.run(Phase::launched, 100);
  const core::Microseconds came = rig.time + tick;
  rig.faults.add(hal::BoardFault::supply_low);
  rig.run(Phase::launched, 1000);
  rig.faults.add(hal::BoardFault::imu_silent);
  rig.run(Phase::launched, 100);
  rig.faults = {};
  rig.run(Phase::launched, 100);
  rig.settle(Phase::armed);
  std::vector<std::uint32_t> told;
  std::vector<core::Microseconds> times;
  for (const protocol::LogEvent& event : events_in(log())) {
    if (event.kind == LogEventKind::board_faults) {
      told.push_back(event.number);
      times.push_back(event.time);
    }
  }
  constexpr std::uint32_t low = 1U << static_cast<unsigned>(hal::BoardFault::supply_low);
  constexpr std::uint32_t silent = 1U << static_cast<unsigned>(hal::BoardFault::imu_silent);
  EXPECT_EQ(told, (std::vector<std::uint32_t>{low, low | silent, 0}));
  EXPECT_EQ(times.at(0), came);
}

TEST_F(RecordedBoard, AFaultThatComesAndGoesEveryTickIsToldTenTimesASecondAtMost) {
  rig.run(Phase::armed, 1000);
  for (int i = 0; i < 2001; ++i) {
    rig.faults = {};
    if (i % 2 == 0) {
      rig.faults.add(hal::BoardFault::imu_silent);
    }
    rig.tick(Phase::launched);
  }
  rig.settle(Phase::armed);
  const auto events = events_in(log());
  const auto told = std::ranges::count(events, LogEventKind::board_faults, &protocol::LogEvent::kind);
  EXPECT_GE(told, 10);
  EXPECT_LE(told, 21);
  EXPECT_EQ(std::ranges::count(events, LogEventKind::records_dropped, &protocol::LogEvent::kind), 0);
}

}  // namespace
}  // namespace fantail::avionics
