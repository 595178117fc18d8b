// SPDX-License-Identifier: MIT
#include "lockstep.hpp"

#include "../core/random_stream.hpp"
#include "bench/sheet.hpp"
#include "test.hpp"

namespace fantail::bench {
namespace {

const sim::CanardTolerances usual{};
constexpr double degree = LockStep::degree;

Sheet sheet_of(const LockStep& rocket) {
  const Exercise exercise = Exercise::limits(rocket.bounds());
  return examine(rocket.record(exercise), exercise, usual, {});
}

// The third canard has this cause, and the others are healthy.
void expect_only_canard_3(const LockStep& rocket, Cause cause) {
  const Sheet sheet = sheet_of(rocket);
  EXPECT_FALSE(sheet.passed());
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(name(sheet.canards[i].diagnosis.cause), name(i == 2 ? cause : Cause::healthy))
        << sentence(i, sheet.canards[i].diagnosis);
  }
}

TEST(LockStepBench, AHealthyRocketPasses) {
  const Sheet sheet = sheet_of({});
  EXPECT_TRUE(sheet.passed()) << sheet_text(sheet);
}

TEST(LockStepBench, AHealthyRocketPassesWithEachLimitThatAPlanMayHave) {
  for (const float limit_deg : {2.0F, 4.0F, 9.0F, 15.0F, 20.0F}) {
    LockStep rocket;
    rocket.plan.controller.canard_limit = core::Angle::from_degrees(limit_deg);
    const Sheet sheet = sheet_of(rocket);
    EXPECT_TRUE(sheet.passed()) << limit_deg << "\n" << sheet_text(sheet);
  }
}

TEST(LockStepBench, AHealthyRocketWithTrimsPasses) {
  LockStep rocket;
  for (std::size_t i = 0; i < 4; ++i) {
    rocket.plan.canards.each[i].trim = core::Angle::from_degrees(static_cast<float>(i) - 1.5F);
  }
  const Sheet sheet = sheet_of(rocket);
  EXPECT_TRUE(sheet.passed()) << sheet_text(sheet);
}

TEST(LockStepBench, FiftyHealthyRocketsWithTheSpreadOfServosAndSensorsPass) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    core::RandomStream random{seed};
    LockStep rocket{.seed = seed};
    const auto spread = [&random] { return static_cast<double>(random.between(0.9F, 1.1F)); };
    for (sim::ServoParameters& servo : rocket.servo) {
      servo.lag_s *= spread();
      servo.delay_s *= spread();
      servo.frame_period_s *= spread();
      servo.rate_limit_rad_s *= spread();
      servo.backlash_rad *= spread();
      servo.stop_rad *= spread();
    }
    rocket.encoder.noise_counts *= spread();
    const Sheet sheet = sheet_of(rocket);
    ASSERT_TRUE(sheet.passed()) << "seed " << seed << "\n" << sheet_text(sheet);
  }
}

TEST(LockStepBench, AReversedCanardIsNamed) {
  LockStep rocket;
  rocket.fault[2] = sim::ServoFault::reversed;
  expect_only_canard_3(rocket, Cause::reversed);
}

TEST(LockStepBench, ASlippingCanardIsNamed) {
  LockStep rocket;
  rocket.fault[2] = sim::ServoFault::slipping;
  expect_only_canard_3(rocket, Cause::slipping);
}

TEST(LockStepBench, ADeadCanardIsNamed) {
  LockStep rocket;
  rocket.fault[2] = sim::ServoFault::dead;
  expect_only_canard_3(rocket, Cause::dead);
}

TEST(LockStepBench, ACanardStuckOffItsCentreIsNamed) {
  LockStep rocket;
  rocket.fault[2] = sim::ServoFault::stuck;
  for (const double angle_deg : {-5.0, -1.5, 1.5, 5.0, 24.0}) {
    rocket.jammed_at_rad[2] = angle_deg * degree;
    expect_only_canard_3(rocket, Cause::stuck);
  }
}

TEST(LockStepBench, ACanardJammedAtItsCentreCannotBeToldFromADeadOne) {
  LockStep rocket;
  rocket.fault[2] = sim::ServoFault::stuck;
  expect_only_canard_3(rocket, Cause::dead);
}

TEST(LockStepBench, ACanardAtItsStopWhateverItIsToldIsStuck) {
  LockStep rocket;
  rocket.fault[2] = sim::ServoFault::hardover;
  expect_only_canard_3(rocket, Cause::stuck);
}

TEST(LockStepBench, ASlowCanardIsNamedHoweverItIsSlow) {
  for (const double lag_s : {0.06, 0.1, 0.2, 0.4}) {
    LockStep rocket;
    rocket.servo[2].lag_s = lag_s;
    expect_only_canard_3(rocket, Cause::slow);
  }
  for (const double rate_deg_s : {15.0, 30.0, 60.0, 150.0}) {
    LockStep rocket;
    rocket.servo[2].rate_limit_rad_s = rate_deg_s * degree;
    expect_only_canard_3(rocket, Cause::slow);
  }
}

TEST(LockStepBench, AnUnpluggedEncoderIsNamed) {
  LockStep rocket;
  rocket.unplugged[2] = true;
  expect_only_canard_3(rocket, Cause::encoder_unplugged);
}

TEST(LockStepBench, ANoisyEncoderIsNamed) {
  for (const double noise_deg : {0.25, 1.0, 3.0}) {
    LockStep rocket;
    rocket.more_noise_rad[2] = noise_deg * degree;
    expect_only_canard_3(rocket, Cause::encoder_noisy);
  }
}

TEST(LockStepBench, AWrongTrimIsNamed) {
  for (const double off_deg : {-3.0, -0.8, 0.8, 3.0}) {
    LockStep rocket;
    rocket.servo[2].pulse_centre_us += 10.0 * off_deg;
    expect_only_canard_3(rocket, Cause::wrong_trim);
  }
}

TEST(LockStepBench, SwappedServoPlugsAreNamedAtBothCanards) {
  LockStep rocket;
  rocket.plug = {0, 2, 1, 3};
  const Sheet sheet = sheet_of(rocket);
  EXPECT_EQ(sheet.canards[0].diagnosis.cause, Cause::healthy);
  EXPECT_EQ(sheet.canards[1].diagnosis.cause, Cause::wrong_canard_moves);
  EXPECT_EQ(sheet.canards[2].diagnosis.cause, Cause::wrong_canard_moves);
  EXPECT_EQ(sheet.canards[3].diagnosis.cause, Cause::healthy);
  EXPECT_NE(sheet.canards[1].diagnosis.seen.find("canard 3 moved"), std::string::npos);
}

TEST(LockStepBench, TooMuchPlayHasNoSingleCause) {
  LockStep rocket;
  rocket.servo[2].backlash_rad = 0.9 * degree;
  expect_only_canard_3(rocket, Cause::out_of_tolerance);
}

TEST(LockStepBench, EveryFaultIsFoundAtEveryCanardWithEverySpread) {
  constexpr std::array faults{sim::ServoFault::reversed, sim::ServoFault::slipping, sim::ServoFault::dead};
  constexpr std::array causes{Cause::reversed, Cause::slipping, Cause::dead};
  for (std::uint32_t seed = 1; seed <= 24; ++seed) {
    core::RandomStream random{seed};
    LockStep rocket{.seed = seed};
    for (sim::ServoParameters& servo : rocket.servo) {
      servo.lag_s *= static_cast<double>(random.between(0.9F, 1.1F));
      servo.rate_limit_rad_s *= static_cast<double>(random.between(0.9F, 1.1F));
    }
    const std::size_t bad = seed % 4;
    const std::size_t which = seed % 3;
    rocket.fault[bad] = faults[which];
    const Sheet sheet = sheet_of(rocket);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(sheet.canards[i].diagnosis.cause, i == bad ? causes[which] : Cause::healthy)
          << "seed " << seed << ": " << sentence(i, sheet.canards[i].diagnosis);
    }
  }
}

TEST(LockStepBench, EveryFaultIsFoundWithEveryLimitThatAPlanMayHave) {
  for (const float limit_deg : {2.0F, 6.0F, 20.0F}) {
    LockStep rocket;
    rocket.plan.controller.canard_limit = core::Angle::from_degrees(limit_deg);
    LockStep reversed = rocket;
    reversed.fault[2] = sim::ServoFault::reversed;
    expect_only_canard_3(reversed, Cause::reversed);
    LockStep slipping = rocket;
    slipping.fault[2] = sim::ServoFault::slipping;
    expect_only_canard_3(slipping, Cause::slipping);
    LockStep dead = rocket;
    dead.fault[2] = sim::ServoFault::dead;
    expect_only_canard_3(dead, Cause::dead);
    LockStep slow = rocket;
    slow.servo[2].lag_s = 0.1;
    expect_only_canard_3(slow, Cause::slow);
    LockStep sluggish = rocket;
    sluggish.servo[2].rate_limit_rad_s = 30.0 * degree;
    expect_only_canard_3(sluggish, Cause::slow);
    LockStep noisy = rocket;
    noisy.more_noise_rad[2] = 0.5 * degree;
    expect_only_canard_3(noisy, Cause::encoder_noisy);
    LockStep off = rocket;
    off.servo[2].pulse_centre_us += 15.0;
    expect_only_canard_3(off, Cause::wrong_trim);
    LockStep stuck = rocket;
    stuck.fault[2] = sim::ServoFault::stuck;
    stuck.jammed_at_rad[2] = 1.5 * degree;
    expect_only_canard_3(stuck, Cause::stuck);
  }
}

}  // namespace
}  // namespace fantail::bench
