// SPDX-License-Identifier: MIT
// The processor is reset in flight, and the whole avionics begins anew.

#include "flying_rig.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using core::Phase;
using hal::ResetCause;

bool within_limits(BoardRig& rig, const core::TickRecord& record) {
  const core::Angle limit = core::default_plan().controller.canard_limit;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const core::CanardCommand& canard = record.canards[i];
    if (!canard.driven || abs(canard.angle) > limit || !rig.servo.written[i]) {
      return false;
    }
  }
  return true;
}

TEST(Resume, ControlGoesOnInTheFirstTickAfterTheReset) {
  FlyingRig rig;
  rig.launch_to_control();
  rig.fly_for(second);
  rig.reset(ResetCause::watchdog);
  const Microseconds before = rig.true_time;
  const core::TickRecord& record = rig.fly();
  EXPECT_EQ(record.phase, Phase::controlling);
  EXPECT_EQ(record.reason, core::PhaseReason::guide_clear);
  EXPECT_EQ(record.command_status, core::CommandStatus::controlling);
  EXPECT_FALSE(record.timing_fault);
  EXPECT_LE(rig.true_time - before + FlyingRig::nominal_gap, 100 * millisecond);
  EXPECT_NE(rig.console.text.find("flight: resumed after a reset\n"), std::string::npos);
}

TEST(Resume, TheCanardsTakeTheirCommandsAtOnceAndNotAsAfterPowerUp) {
  FlyingRig rig;
  rig.launch_to_control();
  rig.fly_for(second);
  rig.disturbance_rad = 0.05;  // of the kind that needs a large command
  rig.fly_for(40 * millisecond);
  rig.reset(ResetCause::software);
  const core::TickRecord& record = rig.fly();
  ASSERT_GT(abs(record.command).degrees(), 1.0F);
  for (const core::CanardCommand& canard : record.canards) {
    EXPECT_EQ(abs(canard.angle), abs(record.command));
  }
}

// What is known after a gap: the rate is taken to go evenly from the one before to the one after. With an acceleration
// of at most A the angle is off by A gap^2 / 4 at most; and where the clock is off by e, by the largest rate times e.
// The gap is that from the last seal, up to 10 ms longer than the time without a processor.
TEST(Resume, AtAnyTickTheRollAngleStaysWithinItsBoundAndTheCommandsWithinTheirs) {
  std::mt19937 random{test::seed()};
  const auto between = [&random](int low, int high) { return std::uniform_int_distribution{low, high}(random); };
  for (int flight = 0; flight < 12; ++flight) {
    FlyingRig rig;
    rig.disturbance_rad = 0.001 * between(-40, 40);
    rig.launch_to_control();
    for (std::uint32_t resume = 0; resume < FlightMemory::most_resumes; ++resume) {
      const core::TickRecord* before = rig.fly_for(between(1, 3000) * millisecond);
      ASSERT_EQ(before->phase, Phase::controlling);
      const double off_before = static_cast<double>(before->motion.roll_angle.radians()) - rig.angle_rad;
      const Microseconds board_before = rig.hardware.time;
      const Microseconds true_before = rig.true_time;
      // The firmware counts on 60 ms from the seal on; this is what it really may be.
      rig.reset(ResetCause::watchdog, between(45, 75) * millisecond);
      const core::TickRecord& record = rig.fly();
      ASSERT_EQ(record.phase, Phase::controlling) << resume;
      ASSERT_FALSE(record.timing_fault);
      ASSERT_TRUE(within_limits(rig, record));
      const double clock_off_s =
          1e-6 *
          std::abs(static_cast<double>(((rig.hardware.time - board_before) - (rig.true_time - true_before)).count()));
      ASSERT_LE(clock_off_s, 0.026);
      const double gap_s = 1e-6 * static_cast<double>((rig.true_time - true_before).count()) + 0.010;
      const double rate = std::max(rig.largest_rate, std::abs(rig.rate_rad_s));
      const double bound = rig.largest_acceleration * gap_s * gap_s / 4.0 + rate * clock_off_s + 0.001 * gap_s;
      const double off = static_cast<double>(record.motion.roll_angle.radians()) - rig.angle_rad;
      EXPECT_LE(std::abs(off - off_before), bound + 2e-3) << "flight " << flight;
      for (int i = 0; i < 500; ++i) {
        const core::TickRecord& next = rig.fly();
        ASSERT_TRUE(within_limits(rig, next));
        ASSERT_FALSE(next.timing_fault);
        ASSERT_EQ(next.phase, Phase::controlling);
        ASSERT_TRUE(std::ranges::all_of(next.verdicts, [](auto v) { return v == core::CanardVerdict::healthy; }));
      }
    }
  }
}

TEST(Resume, AtEveryTickOfTheGuideAndTheFirstControlItGoesOn) {
  constexpr int ticks = 700;
  FlyingRig flown;
  flown.launch();
  flown.fly_to(Phase::launched);
  for (int tick = 0; tick < ticks; tick += 7) {
    const Phase before = flown.fly_for(7 * millisecond)->phase;
    // A copy of what the memory holds, given to another processor.
    FlyingRig other;
    other.true_time = flown.true_time;
    other.lit = flown.lit;
    other.rate_rad_s = flown.rate_rad_s;
    std::ranges::copy(flown.backup_memory.bytes(), other.backup_memory.bytes().begin());
    other.reset(ResetCause::watchdog);
    const Phase after = other.fly_for(2 * millisecond)->phase;
    ASSERT_TRUE(after == before || (before == Phase::launched && after == Phase::controlling)) << tick;
  }
}

TEST(Resume, AFinishedFlightStaysFinished) {
  core::FlightPlan plan = core::default_plan();
  plan.run.control_time = second;
  FlyingRig rig{plan};
  rig.launch_to_control();
  ASSERT_EQ(rig.fly_for(1500 * millisecond)->phase, Phase::finished);
  rig.reset(ResetCause::watchdog);
  const core::TickRecord* record = rig.fly_for(second);
  EXPECT_EQ(record->phase, Phase::finished);
  EXPECT_EQ(record->reason, core::PhaseReason::control_time_over);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
}

TEST(Resume, ControlEndsAtTheTimeAtWhichItWouldHaveEnded) {
  core::FlightPlan plan = core::default_plan();
  plan.run.control_time = second;
  FlyingRig rig{plan};
  rig.launch_to_control();
  const Microseconds begin = rig.true_time;
  rig.fly_for(500 * millisecond);
  rig.reset(ResetCause::watchdog);
  rig.fly_to(Phase::finished);
  // The clock may be off by the age of the last seal.
  EXPECT_NEAR(static_cast<double>((rig.true_time - begin).count()), 1e6, 11e3);
}

TEST(Resume, AnyOtherResetBootsSafeAndBreaksTheSeal) {
  for (const ResetCause cause : {ResetCause::power_on, ResetCause::brown_out, ResetCause::pin}) {
    FlyingRig rig;
    rig.launch_to_control();
    rig.fly_for(second);
    rig.reset(cause);
    EXPECT_EQ(rig.hardware.time, Microseconds{0});
    EXPECT_EQ(rig.fly_for(100 * millisecond)->phase, Phase::safe);
    rig.reset(ResetCause::watchdog);
    EXPECT_EQ(rig.fly_for(100 * millisecond)->phase, Phase::safe) << "what lay there is gone";
  }
}

TEST(Resume, ASealIsBrokenBeforeTheFirstTickAfterAPowerUp) {
  FlyingRig rig;
  rig.launch_to_control();
  rig.reset(ResetCause::power_on);
  rig.reset(ResetCause::watchdog);
  EXPECT_EQ(rig.fly().phase, Phase::safe);
}

TEST(Resume, AResetOnThePadBootsSafeArmedOrNot) {
  for (const bool armed : {false, true}) {
    FlyingRig rig;
    if (armed) {
      ASSERT_EQ(rig.arm().phase, Phase::armed);
    }
    rig.fly_for(second);
    rig.reset(ResetCause::watchdog);
    EXPECT_EQ(rig.fly_for(100 * millisecond)->phase, Phase::safe);
    EXPECT_EQ(rig.console.text.find("flight:"), std::string::npos);
  }
}

TEST(Resume, ALaunchThatWasNoneLeavesNothingBehind) {
  FlyingRig rig;
  rig.launch();
  ASSERT_EQ(rig.fly_to(Phase::launched)->phase, Phase::launched);
  rig.lit.reset();  // only a knock
  ASSERT_EQ(rig.fly_to(Phase::armed)->phase, Phase::armed);
  rig.reset(ResetCause::watchdog);
  EXPECT_EQ(rig.fly_for(100 * millisecond)->phase, Phase::safe);
}

TEST(Resume, AFourthResetOfOneFlightIsNotResumed) {
  FlyingRig rig;
  rig.launch_to_control();
  for (std::uint32_t i = 0; i < FlightMemory::most_resumes; ++i) {
    rig.fly_for(200 * millisecond);
    rig.reset(ResetCause::watchdog);
    ASSERT_EQ(rig.fly().phase, Phase::controlling);
  }
  rig.fly_for(200 * millisecond);
  rig.reset(ResetCause::watchdog);
  EXPECT_EQ(rig.fly().phase, Phase::safe);
  EXPECT_EQ(rig.fly_for(second)->phase, Phase::safe);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  rig.reset(ResetCause::watchdog);
  EXPECT_EQ(rig.fly().phase, Phase::safe);
}

TEST(Resume, AFlightThatCrashesInItsFirstTickIsNotTriedMoreOftenThanAnother) {
  FlyingRig rig;
  rig.launch_to_control();
  rig.fly_for(200 * millisecond);
  int resumed = 0;
  for (int i = 0; i < 10; ++i) {
    rig.reset(ResetCause::watchdog);
    resumed += rig.fly().phase == Phase::controlling ? 1 : 0;
  }
  EXPECT_EQ(resumed, 3);
}

TEST(Resume, TheCountOfOneFlightIsNotThatOfTheNext) {
  core::FlightPlan plan = core::default_plan();
  plan.run.start = core::Start::tunnel;
  FlyingRig rig{plan};
  for (int run = 0; run < 3; ++run) {
    ASSERT_EQ(rig.arm().phase, Phase::armed) << run;
    rig.pc.say(protocol::ArmAction::start, rig.armed_with);
    ASSERT_EQ(rig.fly_to(Phase::controlling)->phase, Phase::controlling);
    rig.fly_for(100 * millisecond);
    for (int i = 0; i < 2; ++i) {
      rig.reset(ResetCause::watchdog);
      ASSERT_EQ(rig.fly_for(100 * millisecond)->phase, Phase::controlling) << run;
    }
    rig.hardware.arm_switch_closed = false;
    std::ranges::fill(rig.flash.cells(), std::byte{0xFF});  // it has room for one run
    rig.reset(ResetCause::pin);
    rig.fly_for(3 * second);
  }
}

TEST(Resume, WithoutBackupMemoryThereIsNoFlightToResume) {
  hal::sim::NoBackupMemory none;
  EXPECT_FALSE(clock_after_reset(none, ResetCause::watchdog, second));
  const hal::sim::WorldSide world;
  const hal::sim::Clock clock{world};
  FlightMemory memory{none, clock, ResetCause::watchdog};
  core::Autopilot law{core::default_plan()};
  EXPECT_FALSE(memory.waits());
  core::TickRecord record;
  record.phase = Phase::controlling;
  memory.keep(record, 0, {}, law);
}

}  // namespace
}  // namespace fantail::avionics
