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

// The watchdog's 1600 cycles of an oscillator of 17 to 47 kHz, with its quarter and 50 ms at 32 kHz, and 7 ms of start.
TEST(FlightMemory, AGapIsThatOfTheClockThatRunsOnWhateverTheOscillatorOfTheWatchdog) {
  constexpr Microseconds assumed = 60 * millisecond;
  for (int oscillator_hz = 17'000; oscillator_hz <= 47'000; oscillator_hz += 1'000) {
    for (int after_seal = 0; after_seal < 10; ++after_seal) {
      Kept rig;
      rig.domain.running = Microseconds{123'456'789};
      rig.since_tick_began = Microseconds{321};  // when the seal is made
      rig.run(20 + after_seal);
      const Microseconds gap{1'600'000'000LL / oscillator_hz + 7'000};
      const Microseconds running = *rig.domain.running + gap;
      const Microseconds truly = rig.clock.shows + gap;
      EXPECT_EQ(clock_after_reset(rig.memory, ResetCause::watchdog, assumed, running), truly) << oscillator_hz;
    }
  }
}

TEST(FlightMemory, AClockThatStoodStillOrWasNotThereIsNotBelieved) {
  constexpr Microseconds assumed = 60 * millisecond;
  Kept rig;
  rig.run(20);
  Memory copy = rig.memory;
  const Microseconds sealed = resume(copy, rig.after(millisecond), rig.plan)->sealed_at;
  copy = rig.memory;
  EXPECT_EQ(clock_after_reset(copy, ResetCause::watchdog, assumed, second), sealed + assumed)
      << "it began after the seal";
  rig.domain.running = Microseconds{0};
  rig.run(20);
  copy = rig.memory;
  const Microseconds later = resume(copy, rig.after(millisecond), rig.plan)->sealed_at;
  copy = rig.memory;
  EXPECT_EQ(clock_after_reset(copy, ResetCause::watchdog, assumed, rig.domain.running), later + assumed) << "it stands";
  copy = rig.memory;
  EXPECT_EQ(clock_after_reset(copy, ResetCause::watchdog, assumed), later + assumed) << "it is gone";
}

TEST(FlightMemory, ATimeOutOfTheCrystalIsInsideTheGap) {
  Kept rig;
  rig.domain.running = second;
  rig.run(20);
  const Microseconds waited = 15 * millisecond;  // for the crystal that did not start
  const Microseconds usual = 57 * millisecond;
  Memory copy = rig.memory;
  const auto without = clock_after_reset(copy, ResetCause::watchdog, 60 * millisecond, *rig.domain.running + usual);
  copy = rig.memory;
  EXPECT_EQ(clock_after_reset(copy, ResetCause::watchdog, 60 * millisecond, *rig.domain.running + usual + waited),
            *without + waited);
}

TEST(FlightMemory, StartsThatNeverCameToATickAreMeasuredTogether) {
  Kept rig;
  rig.domain.running = second;
  rig.run(20);
  const Microseconds truly = rig.clock.shows;
  for (int start = 1; start <= 3; ++start) {
    const Microseconds gap = 17 * millisecond * start;
    EXPECT_EQ(clock_after_reset(rig.memory, ResetCause::software, 10 * millisecond, *rig.domain.running + gap),
              truly + gap);
  }
}

TEST(FlightMemory, TheClockGoesOnFromTheNewestSeal) {
  Kept rig;
  Memory copy = rig.memory;
  const Microseconds sealed = resume(copy, rig.after(millisecond), rig.plan)->sealed_at;
  EXPECT_EQ(clock_after_reset(rig.memory, ResetCause::watchdog, 60 * millisecond), sealed + 60 * millisecond);
}

}  // namespace
}  // namespace fantail::avionics
