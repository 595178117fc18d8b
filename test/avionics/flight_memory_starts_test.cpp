// SPDX-License-Identifier: MIT
// How often a flight may be resumed, and when the clock of a start begins.
#include <gtest/gtest.h>

#include "flight_memory_rig.hpp"

namespace fantail::avionics {
namespace {

TEST(FlightMemory, AResumeCountsThoughTheLawNeverCameToItsNextSeal) {
  Kept rig;
  std::uint32_t resumed = 0;
  for (int i = 0; i < 10; ++i) {
    resumed += resume(rig.memory, rig.after(60 * millisecond), rig.plan) ? 1U : 0U;
  }
  EXPECT_EQ(resumed, FlightMemory::most_resumes);
}

TEST(FlightMemory, AStartThatNeverCameToItsFirstTickCountsAndTakesItsTime) {
  Kept rig;
  Memory copy = rig.memory;
  const Microseconds sealed = resume(copy, rig.after(millisecond), rig.plan)->sealed_at;
  std::optional<Microseconds> clock;
  for (int start = 1; start <= 3; ++start) {
    clock = clock_after_reset(rig.memory, ResetCause::software, 20 * millisecond);
    EXPECT_EQ(clock, sealed + 20 * millisecond * start);
  }
  core::Inputs first = rig.inputs;
  first.time = clock.value();
  copy = rig.memory;
  EXPECT_TRUE(resume(copy, first, rig.plan)) << "the third start of three";
  clock = clock_after_reset(rig.memory, ResetCause::software, 20 * millisecond);
  first.time = clock.value();
  EXPECT_FALSE(resume(rig.memory, first, rig.plan)) << "the fourth";
  EXPECT_FALSE(clock_after_reset(rig.memory, ResetCause::software, 20 * millisecond)) << "and then there is no flight";
}

TEST(FlightMemory, TheClockGoesOnFromTheNewestSeal) {
  Kept rig;
  Memory copy = rig.memory;
  const Microseconds sealed = resume(copy, rig.after(millisecond), rig.plan)->sealed_at;
  EXPECT_EQ(clock_after_reset(rig.memory, ResetCause::watchdog, 60 * millisecond), sealed + 60 * millisecond);
}

}  // namespace
}  // namespace fantail::avionics
