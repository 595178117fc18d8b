// SPDX-License-Identifier: MIT
#include "hal/stm32f4/servo.hpp"

#include <chrono>

#include "fake_timer.hpp"
#include "register_world.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using namespace std::chrono_literals;
using test::FakeTimer;
using test::RegisterWorld;
using Pulses = std::array<std::optional<Pulse>, canards>;

constexpr double full_speed_hz = 168e6;

struct TheServo : testing::Test {
  RegisterWorld world{};
  FakeTimer timer{world};
  Servo servo{timer.registers, 168'000'000};

  [[nodiscard]] double nanoseconds(std::uint64_t counts) const {
    return static_cast<double>(counts * timer.divider()) / full_speed_hz * 1e9;
  }
};

constexpr std::array<bool, 4> nothing_driven{};
constexpr std::array<bool, 4> all_driven{true, true, true, true};
constexpr std::array<std::uint32_t, 4> all_low{};

TEST_F(TheServo, TheFrameIsThreeMillisecondsAndAStepFinerThanATenthOfAMicrosecond) {
  EXPECT_DOUBLE_EQ(nanoseconds(timer.counts_per_frame()), 3e6);
  EXPECT_LT(nanoseconds(1), 100.0);
}

TEST_F(TheServo, AFrameBeginsWhenItIsToldAndThenEveryThreeMilliseconds) {
  for (const Microseconds wait : {0us, 1us, 400us, 2'999us}) {
    timer.pass(1'234);
    servo.begin_frame_in(wait);
    const std::uint64_t told = timer.clocks();
    timer.finish_frame();
    const double waited_us = static_cast<double>(timer.clocks() - told) / full_speed_hz * 1e6;
    EXPECT_NEAR(std::fmod(waited_us, 3'000.0), static_cast<double>(wait.count()), 0.05);
    EXPECT_DOUBLE_EQ(nanoseconds(timer.counts_per_frame()), 3e6);
  }
}

TEST_F(TheServo, OutputsAreOffUntilTheFirstPulse) {
  EXPECT_EQ(timer.next_frame().driven, nothing_driven);
  servo.write({});
  EXPECT_EQ(timer.next_frame().driven, nothing_driven);
}

TEST_F(TheServo, EachPinHasItsOwnPulseToTheNearestCount) {
  servo.write({1'000'000ns, 1'500'033ns, 2'100'000ns, 501'234ns});
  const FakeTimer::Frame frame = timer.next_frame();
  EXPECT_EQ(frame.driven, all_driven);
  const double half_a_count = nanoseconds(1) / 2 + 0.1;
  EXPECT_NEAR(nanoseconds(frame.high[0]), 1'000'000, half_a_count);
  EXPECT_NEAR(nanoseconds(frame.high[1]), 1'500'033, half_a_count);
  EXPECT_NEAR(nanoseconds(frame.high[2]), 2'100'000, half_a_count);
  EXPECT_NEAR(nanoseconds(frame.high[3]), 501'234, half_a_count);
}

TEST_F(TheServo, ThePulsesAreTheSameFromTheSlowClock) {
  FakeTimer slow{world};
  Servo slow_servo{slow.registers, 16'000'000};
  slow_servo.write({1'500'000ns, 1'000'000ns, 2'000'000ns, 2'500'000ns});
  const FakeTimer::Frame frame = slow.next_frame();
  EXPECT_EQ(slow.counts_per_frame() * slow.divider(), 48'000U);  // 3 ms
  const std::array<std::uint32_t, 4> expected{24'000, 16'000, 32'000, 40'000};
  EXPECT_EQ(frame.high, expected);
}

TEST_F(TheServo, TheFirstPulseIsAWholeOne) {
  timer.pass(20'000);
  servo.write({1'500'000ns, 1'500'000ns, 1'500'000ns, 1'500'000ns});
  timer.finish_frame();
  EXPECT_EQ(timer.frames().back().high, all_low);
  timer.finish_frame();
  EXPECT_DOUBLE_EQ(nanoseconds(timer.frames().back().high[0]), 1'500'000);
}

TEST_F(TheServo, AllFourChangeInTheSameFrameWhereverInItTheyAreWritten) {
  const Pulses before{1'000'000ns, 1'100'000ns, 1'200'000ns, 1'300'000ns};
  const Pulses after{2'000'000ns, 2'100'000ns, 2'200'000ns, 2'300'000ns};
  servo.write(before);
  const FakeTimer::Frame old_frame = timer.next_frame();
  servo.write(after);
  const FakeTimer::Frame new_frame = timer.next_frame();
  timer.counts_per_access = 1;
  const std::uint64_t frame = timer.counts_per_frame();
  for (std::uint64_t from_end = 0; from_end < 12; ++from_end) {
    servo.write(before);
    ASSERT_EQ(timer.next_frame(), old_frame);
    timer.pass(frame - from_end);
    const std::size_t first = timer.frames().size() - (from_end == 0 ? 1 : 0);
    servo.write(after);
    timer.finish_frame();
    timer.finish_frame();
    for (std::size_t i = first; i < timer.frames().size(); ++i) {
      EXPECT_TRUE(timer.frames()[i] == old_frame || timer.frames()[i] == new_frame) << from_end << " before the end";
    }
    EXPECT_EQ(timer.frames().back(), new_frame);
  }
}

TEST_F(TheServo, APulseUnderWayIsNotCutByANewOneOrByNone) {
  servo.write({1'500'000ns, 1'500'000ns, 1'500'000ns, 1'500'000ns});
  const FakeTimer::Frame whole = timer.next_frame();
  timer.pass(timer.counts_per_frame() / 4);
  servo.write({500'000ns, std::nullopt, 2'000'000ns, 1'500'000ns});
  timer.finish_frame();
  EXPECT_EQ(timer.frames().back(), whole);
}

TEST_F(TheServo, AnEmptyPulseSwitchesItsOutputOffAndNoOther) {
  servo.write({1'500'000ns, 1'500'000ns, 1'500'000ns, 1'500'000ns});
  const std::uint32_t centre = timer.next_frame().high[0];
  servo.write({1'500'000ns, std::nullopt, 1'500'000ns, 1'500'000ns});
  const std::array<std::uint32_t, 4> expected{centre, 0, centre, centre};
  EXPECT_EQ(timer.next_frame().high, expected);
  servo.write({});
  EXPECT_EQ(timer.next_frame().high, all_low);
}

TEST_F(TheServo, APulseOutsideOfItsRangeLeavesThatServoWhereItIsAndIsCounted) {
  servo.write({1'500'000ns, 1'500'000ns, 1'500'000ns, std::nullopt});
  const FakeTimer::Frame before = timer.next_frame();
  servo.write({499'999ns, 2'500'001ns, -1ns, Pulse::max()});
  EXPECT_EQ(timer.next_frame(), before);
  EXPECT_EQ(servo.refused(), 4U);
  servo.write({500'000ns, 2'500'000ns, 1'500'000ns, std::nullopt});
  EXPECT_EQ(servo.refused(), 4U);
  EXPECT_NEAR(nanoseconds(timer.next_frame().high[1]), 2'500'000, 0.1);
}

TEST_F(TheServo, ACrashHandlerCentresThemWithNothingButTheTimer) {
  const Servo::Counts centre = servo.counts({1'500'000ns, 1'480'000ns, 1'500'000ns, std::nullopt});
  servo.write({1'000'000ns, 1'000'000ns, 2'000'000ns, 2'000'000ns});
  // The crash came in the middle of a write.
  timer.registers.cr1.write(0x83);
  Servo::drive(timer.registers, centre);
  const FakeTimer::Frame frame = timer.next_frame();
  EXPECT_NEAR(nanoseconds(frame.high[0]), 1'500'000, 24);
  EXPECT_NEAR(nanoseconds(frame.high[1]), 1'480'000, 24);
  EXPECT_EQ(frame.high[3], 0U);
}

TEST_F(TheServo, AResetAfterACrashCutsNoPulseWheneverTheCrashComes) {
  const Pulses at_trim{1'500'000ns, 1'480'000ns, 1'510'000ns, 1'500'000ns};
  servo.write(at_trim);
  const FakeTimer::Frame centre = timer.next_frame();
  const Servo::Counts counts = servo.counts(at_trim);
  for (std::uint64_t crash = 0; crash < timer.counts_per_frame(); crash += 997) {
    timer.counts_per_access = 0;
    timer.reset();
    Servo begun_anew{timer.registers, 168'000'000};
    begun_anew.write({2'500'000ns, 1'000'000ns, 2'000'000ns, std::nullopt});
    const FakeTimer::Frame steered = timer.next_frame();
    timer.pass(crash);
    const std::size_t first = timer.frames().size();
    timer.counts_per_access = 3;
    EXPECT_TRUE(Servo::finish(timer.registers, counts));
    for (std::size_t i = first; i < timer.frames().size(); ++i) {
      EXPECT_TRUE(timer.frames()[i] == steered || timer.frames()[i] == centre) << crash;
    }
    EXPECT_EQ(timer.unfinished().high, centre.high) << crash << ": the pulses at trim are whole";
    EXPECT_LE(timer.frames().size() - first, 2U) << crash;
    EXPECT_TRUE(std::ranges::all_of(timer.pulses(), &FakeTimer::Pulse::whole)) << crash;
  }
}

TEST_F(TheServo, AfterTheLastPulsesOfACrashTheLinesAreHeldLowHoweverLongTheResetTakes) {
  const Pulses at_trim{1'500'000ns, 1'480'000ns, 1'510'000ns, 1'500'000ns};
  servo.write(at_trim);
  timer.next_frame();
  timer.pass(20'000);
  timer.counts_per_access = 3;
  ASSERT_TRUE(Servo::finish(timer.registers, servo.counts(at_trim)));
  EXPECT_TRUE(timer.holds_low());
  const std::size_t pulses = timer.pulses().size();
  timer.pass(3 * timer.counts_per_frame());
  timer.reset();
  EXPECT_EQ(timer.pulses().size(), pulses);
  EXPECT_TRUE(std::ranges::all_of(timer.pulses(), &FakeTimer::Pulse::whole));
}

// At 16 MHz instead of 168 a pulse would take ten times as long, and the wait for its end longer than the watchdog's.
TEST_F(TheServo, WhereItsClockHasFailedTheLinesAreLowAtOnce) {
  servo.write({1'500'000ns, 1'480'000ns, 1'510'000ns, 1'500'000ns});
  timer.next_frame();
  timer.pass(20'000);
  const std::uint64_t failed = timer.clocks();
  Servo::hold_low(timer.registers);
  timer.pass(3 * timer.counts_per_frame());
  EXPECT_TRUE(timer.holds_low());
  ASSERT_GE(timer.pulses().size(), 4U);
  for (const FakeTimer::Pulse& pulse : timer.pulses()) {
    EXPECT_LE(pulse.begin + pulse.width, failed);
  }
  EXPECT_FALSE(timer.pulses().back().whole);
}

TEST_F(TheServo, ATimerThatStandsIsNotWaitedForForEver) {
  servo.write({1'500'000ns, 1'500'000ns, 1'500'000ns, 1'500'000ns});
  EXPECT_FALSE(Servo::finish(timer.registers, servo.counts({1'500'000ns}))) << "its counter never moves in this test";
  EXPECT_TRUE(timer.holds_low()) << "a line that stood high for so long carries no pulse";
}

TEST_F(TheServo, ACrashBeforeTheFirstPulseDrivesNothing) {
  Servo::drive(timer.registers, servo.counts({1'500'000ns, 1'500'000ns, 1'500'000ns, 1'500'000ns}));
  EXPECT_EQ(timer.next_frame().driven, nothing_driven);
}

}  // namespace
}  // namespace fantail::hal::stm32f4
