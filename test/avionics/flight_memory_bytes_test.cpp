// SPDX-License-Identifier: MIT

#include "avionics/write_state.hpp"
#include "flight_memory_rig.hpp"
#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

// What a half holds, byte by byte, whatever lay there before.

using protocol::get;
using protocol::put;

constexpr std::size_t room_of_state = flight_half_size - 48;

// A time, a plan and a number of sectors with no byte that is zero.
constexpr Microseconds long_time{0x0102030405060708};
constexpr std::uint32_t many_sectors = 0xA1B2C3D4;

// A memory that is found full of ones after power-up, and the record of one tick of a flight.
struct OneSeal {
  core::Autopilot law{core::default_plan()};
  Memory memory = [] {
    Memory ones;
    ones.fill(std::byte{0xFF});
    return ones;
  }();
  Domain domain{memory};
  SetClock clock;
  FlightMemory kept{domain, clock, ResetCause::power_on};
  core::TickRecord record{};

  OneSeal() {
    record.time = long_time;
    record.phase = Phase::controlling;
  }
  void keep(std::optional<std::uint32_t> sectors) { kept.keep(record, plan_crc, sectors, law); }
  std::span<std::byte> sealed_half() {
    const auto first = flight_half(memory, 0);
    return get<4>(first, 4) != 0 ? first : flight_half(memory, 1);
  }
};

TEST(FlightMemory, AHalfIsWhatTheTableOfItsBytesSays) {
  for (const bool sectors_known : {false, true}) {
    for (const bool clock_runs_on : {false, true}) {
      OneSeal rig;
      rig.clock.shows = Microseconds{1'000};
      if (clock_runs_on) {
        rig.domain.running = Microseconds{0x1112131415161718 + 1'000};
      }
      rig.keep(sectors_known ? std::optional{many_sectors} : std::nullopt);
      const auto half = rig.sealed_half();
      const std::vector<std::byte> begin(half.begin(), half.begin() + 4);
      EXPECT_EQ(begin, (std::vector{std::byte{'F'}, std::byte{'F'}, std::byte{'L'}, std::byte{'M'}}));
      std::vector<std::byte> state(room_of_state);
      state.resize(write_state(rig.law, state, protocol::StateExtent::in_flight));
      EXPECT_EQ(get<4>(half, 4), protocol::crc32c(half.subspan(8, 40 + state.size())));
      EXPECT_EQ(get<4>(half, 8), 1U) << "the first of a flight";
      EXPECT_EQ(get<8>(half, 12), 0x0102030405060708U);
      EXPECT_EQ(get<4>(half, 20), plan_crc);
      EXPECT_EQ(get<4>(half, 24), state_layout(rig.law));
      EXPECT_EQ(get<4>(half, 28), 0U) << "resumes";
      EXPECT_EQ(get<4>(half, 32), sectors_known ? many_sectors : 0U);
      EXPECT_EQ(get<1>(half, 36), (sectors_known ? 1U : 0U) + (clock_runs_on ? 2U : 0U));
      EXPECT_EQ(get<1>(half, 37), 0U) << "starts";
      EXPECT_EQ(get<2>(half, 38), state.size());
      EXPECT_EQ(get<8>(half, 40), clock_runs_on ? 0x1112131415161718U : 0U);
      EXPECT_TRUE(std::ranges::equal(half.subspan(48, state.size()), state));
    }
  }
}

TEST(FlightMemory, WhatIsKnownOfTheFlashAndOfTheClockIsKnownApart) {
  Kept only_clock;
  only_clock.domain.running = second;
  only_clock.run(20);
  const auto resumed = resume(only_clock.memory, only_clock.after(60 * millisecond), only_clock.plan);
  ASSERT_TRUE(resumed);
  EXPECT_FALSE(resumed->used_sectors);

  Kept only_sectors;
  only_sectors.sectors = 17;
  only_sectors.run(20);
  Memory copy = only_sectors.memory;
  const Microseconds sealed = resume(copy, only_sectors.after(millisecond), only_sectors.plan)->sealed_at;
  EXPECT_EQ(clock_after_reset(only_sectors.memory, ResetCause::watchdog, 60 * millisecond, 1000 * second),
            sealed + 60 * millisecond)
      << "a clock that begins to run with the reset has measured nothing";
}

// A half whose seal is right, with a state of that size.
Memory with_a_state_of(std::size_t size) {
  OneSeal rig;
  rig.keep({});
  Memory memory = rig.memory;
  const auto half = flight_half(memory, 0);
  std::ranges::copy(rig.sealed_half().first(48), half.begin());
  std::ranges::fill(flight_half(memory, 1).first(8), std::byte{0});
  put<2>(half, 38, size);
  put<4>(half, 4, protocol::crc32c(std::span{memory}.subspan(8, 40 + size)));
  return memory;
}

TEST(FlightMemory, AStateMayFillItsHalfToTheLastByteAndNoFurther) {
  for (const std::size_t size : {room_of_state - 1, room_of_state, room_of_state + 1, room_of_state + 48}) {
    Memory memory = with_a_state_of(size);
    Domain domain{memory};
    const SetClock clock;
    const FlightMemory found{domain, clock, ResetCause::watchdog};
    EXPECT_EQ(found.waits(), size <= room_of_state) << size;
  }
}

// How often a flight may be resumed, and when the clock of a start begins.

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
