// SPDX-License-Identifier: MIT
#include "avionics/flight_memory.hpp"

#include "avionics/backup_map.hpp"
#include "avionics/write_state.hpp"
#include "flight_memory_rig.hpp"
#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"
#include "protocol/state_block.hpp"
#include "protocol/tick_digest.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

bool half_is_broken(Memory& memory, std::size_t half) {
  const auto bytes = flight_half(memory, half);
  return std::all_of(bytes.begin(), bytes.begin() + 8, [](std::byte byte) { return byte == std::byte{0}; });
}

TEST(FlightMemory, TheStateFitsIntoAHalfAndTheHalvesLeaveTheRoomForACrash) {
  core::Autopilot law{core::default_plan()};
  protocol::StateWriter measure{{}, protocol::StateExtent::in_flight};
  law.visit_state(measure);
  EXPECT_LE(measure.size() + 48, flight_half_size);
  EXPECT_EQ(crash_begin + crash_room, backup_size);
  EXPECT_EQ(crash_begin, 2 * flight_half_size);
}

TEST(FlightMemory, KeepsEveryTenMillisecondsInTurnAndTheStateIsTheLawsOwn) {
  Kept rig;
  std::vector<Microseconds> times;
  for (int i = 0; i < 100; ++i) {
    rig.tick();
    Memory copy = rig.memory;
    times.push_back(resume(copy, rig.after(60 * millisecond), rig.plan)->sealed_at);
  }
  times.erase(std::unique(times.begin(), times.end()), times.end());
  ASSERT_GE(times.size(), 10U);
  for (std::size_t i = 1; i < times.size(); ++i) {
    EXPECT_EQ(times[i] - times[i - 1], FlightMemory::period);
  }
  EXPECT_LE(rig.inputs.time - times.back(), FlightMemory::period);
}

TEST(FlightMemory, WhatComesBackGoesOnAsTheLawItselfWouldHave) {
  Kept rig;
  while (resume(*std::make_unique<Memory>(rig.memory), rig.after(millisecond), rig.plan)->sealed_at !=
         rig.inputs.time) {
    rig.tick();
  }
  Domain domain{rig.memory};
  FlightMemory found{domain, rig.clock, ResetCause::software};
  core::Autopilot law{rig.plan};
  ASSERT_TRUE(found.resume(rig.after(60 * millisecond), plan_crc, law));
  rig.law.resume(rig.after(60 * millisecond));
  core::Inputs inputs = rig.after(60 * millisecond);
  for (int i = 0; i < 5000; ++i) {
    inputs.gyro.rate_rad_s.x = 0.1F * static_cast<float>(i % 50);
    ASSERT_EQ(protocol::tick_digest(law.step(inputs)), protocol::tick_digest(rig.law.step(inputs))) << i;
    inputs.time += millisecond;
    inputs.gyro.time = inputs.accelerometers[0].time = inputs.accelerometers[1].time = inputs.time;
  }
}

TEST(FlightMemory, EverySingleBitThatFlipsBreaksItsHalfAndTheOtherOneIsTaken) {
  Kept rig;
  const core::Inputs first = rig.after(50 * millisecond);
  Memory whole = rig.memory;
  const auto newest = resume(whole, first, rig.plan);
  ASSERT_TRUE(newest);
  const Microseconds other = newest->sealed_at - FlightMemory::period;
  const std::size_t state_size = [&rig] {
    protocol::StateWriter measure{{}, protocol::StateExtent::in_flight};
    rig.law.visit_state(measure);
    return measure.size();
  }();
  // Which half is the newer one shows when it is gone.
  Memory without = rig.memory;
  std::ranges::fill(flight_half(without, 0), std::byte{0});
  const std::size_t newer = resume(without, first, rig.plan)->sealed_at == other ? 0 : 1;
  for (const std::size_t half : {std::size_t{0}, std::size_t{1}}) {
    const Microseconds expected = half == newer ? other : newest->sealed_at;
    for (std::size_t bit = 0; bit < 8 * (47 + state_size); ++bit) {
      Memory memory = rig.memory;
      flight_half(memory, half)[bit / 8] ^= std::byte{1} << (bit % 8);
      const auto found = resume(memory, first, rig.plan);
      ASSERT_TRUE(found) << bit;
      ASSERT_EQ(found->sealed_at, expected) << bit;
    }
  }
}

TEST(FlightMemory, WithBothHalvesSpoiltThereIsNothingToResume) {
  const Kept rig;
  std::mt19937 random{test::seed()};
  for (int i = 0; i < 500; ++i) {
    Memory memory = rig.memory;
    for (const std::size_t half : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t bit = random() % 4800;
      flight_half(memory, half)[bit / 8] ^= std::byte{1} << (bit % 8);
    }
    ASSERT_FALSE(resume(memory, rig.after(60 * millisecond), rig.plan));
    ASSERT_TRUE(half_is_broken(memory, 0) && half_is_broken(memory, 1));
  }
}

TEST(FlightMemory, MemoryThatIsAnythingIsNoFlight) {
  const Kept rig;
  std::mt19937 random{test::seed(7)};
  Memory memory{};
  for (int i = 0; i < 200; ++i) {
    std::ranges::generate(memory, [&] { return std::byte{static_cast<std::uint8_t>(random())}; });
    if (i < 2) {
      memory.fill(i == 0 ? std::byte{0} : std::byte{0xFF});
    }
    ASSERT_FALSE(resume(memory, rig.after(60 * millisecond), rig.plan));
  }
}

// A reset may come between any two stores, and the compiler may have put them in another order.
TEST(FlightMemory, AResetInTheMiddleOfASealLeavesTheOtherHalf) {
  Kept rig;
  Memory before = rig.memory;
  do {
    before = rig.memory;
    rig.tick();
  } while (rig.memory == before);
  const Microseconds new_time = rig.inputs.time;
  for (std::size_t cut = 0; cut <= crash_begin; ++cut) {
    for (const bool from_below : {true, false}) {
      Memory torn = from_below ? before : rig.memory;
      const Memory& written = from_below ? rig.memory : before;
      std::copy_n(written.begin(), cut, torn.begin());
      const auto found = resume(torn, rig.after(60 * millisecond), rig.plan);
      ASSERT_TRUE(found) << cut;
      ASSERT_TRUE(found->sealed_at == new_time || found->sealed_at == new_time - FlightMemory::period) << cut;
    }
  }
}

TEST(FlightMemory, AnotherPlanOrAnotherLawIsNotGivenTheState) {
  const Kept rig;
  const core::Inputs first = rig.after(60 * millisecond);
  Memory memory = rig.memory;
  EXPECT_FALSE(resume(memory, first, rig.plan, plan_crc + 1));
  EXPECT_TRUE(half_is_broken(memory, 0) && half_is_broken(memory, 1));
  memory = rig.memory;
  core::FlightPlan with_another_layout = rig.plan;
  with_another_layout.sensors.gyros = core::GyroRule::two_agree;
  EXPECT_FALSE(resume(memory, first, with_another_layout));
}

// Both halves with another state, sealed as if it had been kept so.
template <typename Change>
Memory sealed_with(const Kept& rig, Change change) {
  Memory memory = rig.memory;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const auto half = flight_half(memory, i);
    const auto size = static_cast<std::size_t>(protocol::get<2>(half, 38));
    change(half.subspan(48, size));
    protocol::put<4>(half, 4, protocol::crc32c(half.subspan(8, 40 + size)));
  }
  return memory;
}

TEST(FlightMemory, AStateThatIsNoneIsNotResumedThoughItsSealIsWhole) {
  Kept rig;
  const core::Inputs first = rig.after(60 * millisecond);
  Memory same = sealed_with(rig, [](std::span<std::byte>) {});
  EXPECT_TRUE(resume(same, first, rig.plan)) << "what this test does to a half is what keep() does";
  Memory broken = sealed_with(rig, [](std::span<std::byte> state) { std::ranges::fill(state, std::byte{0xFF}); });
  EXPECT_FALSE(resume(broken, first, rig.plan));
  core::Autopilot on_the_pad{rig.plan};
  Memory safe = sealed_with(rig, [&](std::span<std::byte> state) {
    EXPECT_EQ(write_state(on_the_pad, state, protocol::StateExtent::in_flight), state.size());
  });
  EXPECT_FALSE(resume(safe, first, rig.plan));
}

TEST(FlightMemory, OnlyAResetThatTheWatchdogOrTheFirmwareAskedForIsOneToGoOnAfter) {
  const Kept rig;
  for (const ResetCause cause :
       {ResetCause::power_on, ResetCause::brown_out, ResetCause::pin, ResetCause::software, ResetCause::watchdog}) {
    Memory memory = rig.memory;
    const bool allowed = cause == ResetCause::software || cause == ResetCause::watchdog;
    EXPECT_EQ(clock_after_reset(memory, cause, millisecond).has_value(), allowed);
    EXPECT_EQ(resume(memory, rig.after(60 * millisecond), rig.plan, plan_crc, cause).has_value(), allowed);
    EXPECT_EQ(half_is_broken(memory, 0) && half_is_broken(memory, 1), !allowed);
  }
}

TEST(FlightMemory, AGapThatIsTooLongOrRunsBackwardsIsNone) {
  Kept rig;
  Memory copy = rig.memory;
  const Microseconds sealed = resume(copy, rig.after(millisecond), rig.plan)->sealed_at;
  const auto goes_on_at = [&](Microseconds time) {
    Memory memory = rig.memory;
    core::Inputs first = rig.inputs;
    first.time = time;
    return resume(memory, first, rig.plan).has_value();
  };
  EXPECT_TRUE(goes_on_at(sealed + FlightMemory::longest_gap));
  EXPECT_FALSE(goes_on_at(sealed + FlightMemory::longest_gap + Microseconds{1}));
  EXPECT_TRUE(goes_on_at(sealed)) << "from the older half";
  EXPECT_FALSE(goes_on_at(sealed - FlightMemory::period));
  EXPECT_FALSE(goes_on_at(Microseconds{1000})) << "a clock that nobody set";
}

TEST(FlightMemory, WhatIsKnownOfTheFlashComesBackToo) {
  Kept rig;
  Memory memory = rig.memory;
  EXPECT_FALSE(resume(memory, rig.after(60 * millisecond), rig.plan)->used_sectors);
  rig.sectors = 17;
  rig.run(20);
  EXPECT_EQ(resume(rig.memory, rig.after(60 * millisecond), rig.plan)->used_sectors, 17U);
}

TEST(FlightMemory, TheRoomOfTheCrashRecordIsNeverTouched) {
  Kept rig;
  std::ranges::fill(crash_place(rig.memory), std::byte{0x5A});
  rig.run(100);
  (void)resume(rig.memory, rig.after(60 * millisecond), rig.plan);
  Domain domain{rig.memory};
  const FlightMemory forgets{domain, rig.clock, ResetCause::pin};
  EXPECT_TRUE(std::ranges::all_of(crash_place(rig.memory), [](std::byte b) { return b == std::byte{0x5A}; }));
}

TEST(FlightMemory, OnThePadTheSealIsBrokenAtOnce) {
  Kept rig;
  core::TickRecord record;
  record.time = rig.inputs.time + millisecond;
  record.phase = Phase::armed;
  rig.kept.keep(record, plan_crc, {}, rig.law);
  EXPECT_TRUE(half_is_broken(rig.memory, 0) && half_is_broken(rig.memory, 1));
}

}  // namespace
}  // namespace fantail::avionics
