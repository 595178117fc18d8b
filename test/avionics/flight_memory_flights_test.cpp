// SPDX-License-Identifier: MIT
// From one seal, one resume, one flight and one plan to the next.

#include "avionics/write_state.hpp"
#include "flight_memory_rig.hpp"
#include "protocol/little_endian.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using protocol::ResumedAfter;

bool holds_nothing(Memory memory) {
  Domain domain{memory};
  const SetClock clock;
  return !FlightMemory{domain, clock, ResetCause::watchdog}.waits();
}

core::TickRecord record_of(Phase phase, Microseconds time) {
  core::TickRecord record;
  record.phase = phase;
  record.time = time;
  return record;
}

// A flight that was sealed for the first time, at 1 s, in a memory that had been full of ones: after power-up it may be
// full of anything.
struct FirstSeal {
  Kept rig;
  Memory memory = [] {
    Memory ones;
    ones.fill(std::byte{0xFF});
    return ones;
  }();
  Domain domain{memory};
  FlightMemory kept{domain, rig.clock, ResetCause::power_on};

  FirstSeal() { keep(Phase::controlling, second); }
  void keep(Phase phase, Microseconds time) { kept.keep(record_of(phase, time), plan_crc, {}, rig.law); }
  [[nodiscard]] core::Inputs at(Microseconds time) const {
    core::Inputs first = rig.inputs;
    first.time = first.gyro.time = time;
    return first;
  }
};

TEST(FlightMemory, AFlightCanBeResumedFromItsFirstSealAndNoMoreOftenThanAnother) {
  FirstSeal flight;
  for (int reset = 1; reset <= 3; ++reset) {
    const auto resumed = resume(flight.memory, flight.at(second + Microseconds{1}), flight.rig.plan);
    ASSERT_TRUE(resumed) << reset;
    EXPECT_EQ(resumed->sealed_at, second);
  }
  EXPECT_FALSE(resume(flight.memory, flight.at(second + Microseconds{1}), flight.rig.plan));
}

TEST(FlightMemory, AFlightThatWasNoneAfterItsFirstSealIsForgottenAndTheNextIsSealedAtOnce) {
  FirstSeal flight;
  flight.keep(Phase::armed, second + millisecond);
  EXPECT_TRUE(holds_nothing(flight.memory));
  flight.keep(Phase::launched, second + 2 * millisecond);
  EXPECT_EQ(resume(flight.memory, flight.at(second + 3 * millisecond), flight.rig.plan)->sealed_at,
            second + 2 * millisecond);
}

TEST(FlightMemory, AQuarterOfASecondIsTheLongestGapAndAMicrosecondTheShortest) {
  const auto goes_on_after = [](Microseconds gap) {
    FirstSeal flight;
    return resume(flight.memory, flight.at(second + gap), flight.rig.plan).has_value();
  };
  EXPECT_FALSE(goes_on_after(Microseconds{0}));
  EXPECT_TRUE(goes_on_after(Microseconds{1}));
  EXPECT_TRUE(goes_on_after(Microseconds{250'000}));
  EXPECT_FALSE(goes_on_after(Microseconds{250'001}));
}

TEST(FlightMemory, AResumeSaysWhichResetItFollows) {
  FirstSeal flight;
  const core::Inputs first = flight.at(second + 60 * millisecond);
  EXPECT_EQ(resume(flight.memory, first, flight.rig.plan, plan_crc, ResetCause::watchdog)->after,
            ResumedAfter::watchdog);
  EXPECT_EQ(resume(flight.memory, first, flight.rig.plan, plan_crc, ResetCause::software)->after,
            ResumedAfter::software);
}

TEST(FlightMemory, ATimeOfAnyLengthComesBack) {
  constexpr Microseconds far_time{0x0102030405060708};
  FirstSeal flight;
  flight.keep(Phase::controlling, far_time);
  EXPECT_EQ(clock_after_reset(flight.memory, ResetCause::watchdog, 20 * millisecond), far_time + 20 * millisecond);
}

TEST(FlightMemory, WhileAFlightWaitsToBeResumedNothingIsKept) {
  FirstSeal flight;
  flight.keep(Phase::controlling, second + 10 * millisecond);
  for (const Phase phase : {Phase::safe, Phase::controlling}) {
    Memory memory = flight.memory;
    Domain domain{memory};
    FlightMemory found{domain, flight.rig.clock, ResetCause::watchdog};
    ASSERT_TRUE(found.waits());
    EXPECT_EQ(found.resumes(), 0U);
    found.keep(record_of(phase, 2 * second), plan_crc, {}, flight.rig.law);
    EXPECT_EQ(memory, flight.memory);
  }
}

// Each time with the count of the resumes, whichever half was written last.
TEST(FlightMemory, AResumedFlightIsKeptAndResumedAsOneThatWasNeverReset) {
  for (const int seals : {1, 2}) {
    FirstSeal flight;
    Microseconds time = second;
    if (seals == 2) {
      time += 10 * millisecond;
      flight.keep(Phase::controlling, time);
    }
    for (std::uint32_t resumes = 1; resumes <= 3; ++resumes) {
      FlightMemory found{flight.domain, flight.rig.clock, ResetCause::watchdog};
      ASSERT_TRUE(found.waits());
      core::Autopilot law{flight.rig.plan};
      const auto resumed = found.resume(flight.at(time + 60 * millisecond), plan_crc, law);
      ASSERT_TRUE(resumed) << resumes;
      EXPECT_EQ(resumed->sealed_at, time);
      EXPECT_FALSE(found.waits());
      EXPECT_EQ(found.resumes(), resumes);
      time += 60 * millisecond;
      found.keep(record_of(Phase::controlling, time), plan_crc, {}, law);
    }
    FlightMemory fourth{flight.domain, flight.rig.clock, ResetCause::watchdog};
    core::Autopilot law{flight.rig.plan};
    EXPECT_FALSE(fourth.resume(flight.at(time + 60 * millisecond), plan_crc, law));
  }
}

TEST(FlightMemory, AFlightThatFollowsAResumedOneWithoutAResetHasItsOwnThreeResumes) {
  FirstSeal flight;
  FlightMemory found{flight.domain, flight.rig.clock, ResetCause::watchdog};
  ASSERT_TRUE(found.resume(flight.at(second + 60 * millisecond), plan_crc, flight.rig.law));
  found.keep(record_of(Phase::safe, 2 * second), plan_crc, {}, flight.rig.law);
  EXPECT_EQ(found.resumes(), 0U);
  Kept another;
  found.keep(record_of(Phase::controlling, 3 * second), plan_crc, {}, another.law);
  int resumed = 0;
  for (int i = 0; i < 10; ++i) {
    resumed += resume(flight.memory, flight.at(3 * second + 60 * millisecond), another.plan) ? 1 : 0;
  }
  EXPECT_EQ(resumed, 3);
}

// Seven bits count the starts: in the eighth the count would begin anew, and the flight would be flown on.
TEST(FlightMemory, HoweverManyStartsNeverComeToATickTheirCountDoesNotBeginAnew) {
  FirstSeal flight;
  for (int start = 1; start <= 300; ++start) {
    ASSERT_EQ(clock_after_reset(flight.memory, ResetCause::software, 20 * millisecond),
              second + 20 * millisecond * std::min(start, 127));
  }
  EXPECT_FALSE(resume(flight.memory, flight.at(second + 60 * millisecond), flight.rig.plan));
}

// The flash or the bus may bring another plan between two flights of one start; its CRC may be any, also 0.
TEST(FlightMemory, AFlightByAnotherPlanIsKeptWithThatPlansLayout) {
  core::FlightPlan with_another_layout = core::default_plan();
  with_another_layout.run.start = core::Start::tunnel;
  with_another_layout.sensors.gyros = core::GyroRule::two_agree;
  core::Autopilot other_law{with_another_layout};
  Kept one;
  ASSERT_NE(state_layout(one.law), state_layout(other_law));
  for (const bool other_first : {false, true}) {
    Memory memory{};
    Domain domain{memory};
    FlightMemory kept{domain, one.clock, ResetCause::power_on};
    const auto layout_of = [&](core::Autopilot& law, std::uint32_t crc, Microseconds time) {
      kept.keep(record_of(Phase::controlling, time), crc, {}, law);
      const auto half = flight_half(memory, protocol::get<4>(memory, 4) != 0 ? 0 : 1);  // the one whose seal is whole
      const auto layout = static_cast<std::uint32_t>(protocol::get<4>(half, 24));
      kept.keep(record_of(Phase::safe, time + millisecond), crc, {}, law);
      return layout;
    };
    core::Autopilot& first = other_first ? other_law : one.law;
    core::Autopilot& second_law = other_first ? one.law : other_law;
    EXPECT_EQ(layout_of(first, other_first ? 0 : 7, second), state_layout(first));
    EXPECT_EQ(layout_of(second_law, other_first ? 7 : 0, 2 * second), state_layout(second_law));
  }
}

// Of a gap that is taken for 60 ms.
TEST(FlightMemory, AClockThatRanOnForHalfTheAssumedGapIsBelievedAndOneThatRanLessIsNot) {
  const auto goes_on_after = [](Microseconds ran) {
    Kept rig;
    Memory memory{};
    Domain domain{memory};
    domain.running = 5 * second;
    rig.clock.shows = second;
    FlightMemory kept{domain, rig.clock, ResetCause::power_on};
    kept.keep(record_of(Phase::controlling, second), plan_crc, {}, rig.law);
    return *clock_after_reset(memory, ResetCause::watchdog, 60 * millisecond, 5 * second + ran) - second;
  };
  EXPECT_EQ(goes_on_after(30 * millisecond), 30 * millisecond);
  EXPECT_EQ(goes_on_after(30 * millisecond - Microseconds{1}), 60 * millisecond);
}

// A tick that ends a gap has no length; then the servo brings the canard to its command, and each millisecond takes two
// off the 100 of the hold.
TEST(FlightMemory, AVerdictOnACanardOutlivesTheResetUntilHalfTheHoldHasGone) {
  Kept rig;
  rig.inputs.encoders.fill(core::Angle{});
  rig.run(100);
  rig.inputs.encoders[2] = core::Angle::from_degrees(4.0F);
  rig.run(200);
  Domain domain{rig.memory};
  FlightMemory found{domain, rig.clock, ResetCause::watchdog};
  core::Autopilot law{rig.plan};
  core::Inputs inputs = rig.after(60 * millisecond);
  ASSERT_TRUE(found.resume(inputs, plan_crc, law));
  for (int i = 0; i <= 50; ++i) {
    const core::TickRecord& record = law.step(inputs);
    ASSERT_EQ(record.verdicts[2] == core::CanardVerdict::healthy, i == 50) << i;
    for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
      const core::Angle at = *inputs.encoders[canard];
      inputs.encoders[canard] = at + (record.canards[canard].angle - at) / 25.0F;
    }
    inputs.time += millisecond;
    inputs.gyro.time = inputs.time;
  }
}

}  // namespace
}  // namespace fantail::avionics
