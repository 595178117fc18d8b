// SPDX-License-Identifier: MIT
#include "avionics/self_test.hpp"

#include "avionics/self_test_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using namespace core::literals;
using protocol::ArmAction;
using protocol::ArmReply;
using protocol::SelfTestFailure;
using protocol::SelfTestState;

TEST(SelfTest, ASoundRocketPassesWithinTenSecondsOfPowerUp) {
  BoardRig rig;
  EXPECT_EQ(outcome(rig).self_test, SelfTestState::passed);
  EXPECT_LT(rig.hardware.time, 10 * second);
}

TEST(SelfTest, EachCanardAloneMovesThreeDegreesOutAndBack) {
  BoardRig rig;
  rig.pc.say(ArmAction::self_test);
  std::array<double, 4> highest{};
  std::size_t most_at_once = 0;
  for (Microseconds t{}; t < 9 * second; t += millisecond) {
    rig.tick();
    std::size_t away = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double angle_deg = rig.servo.written[i] ? rig.commanded_deg(i) : 0.0;
      highest[i] = std::max(highest[i], angle_deg);
      away += angle_deg > 0.01 || angle_deg < -0.01 ? 1 : 0;
    }
    most_at_once = std::max(most_at_once, away);
  }
  EXPECT_EQ(most_at_once, 1U);
  for (const double angle_deg : highest) {
    EXPECT_NEAR(angle_deg, 3.0, 0.01);
  }
  EXPECT_TRUE(rig.all_pulses_are(0.0));
}

TEST(SelfTest, ASmallPlanLimitIsNeverExceeded) {
  core::FlightPlan plan = core::default_plan();
  plan.controller.canard_limit = 2_deg;
  plan.canards.each[0].trim = 1.5_deg;
  BoardRig rig{plan};
  rig.pc.say(ArmAction::self_test);
  for (Microseconds t{}; t < 9 * second; t += millisecond) {
    rig.tick();
    for (std::size_t i = 0; i < 4 && rig.servo.written[0]; ++i) {
      ASSERT_LE(std::abs(rig.commanded_deg(i)), 2.001);
    }
  }
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::passed);
}

TEST(SelfTest, FailsWhenTheRocketMovesAllTheTime) {
  BoardRig rig;
  rig.hardware.imu.rate = {500, 0, 0};
  expect_failure(rig, SelfTestFailure::moved);
}

TEST(SelfTest, WaitsForAHandToLetGo) {
  BoardRig rig;
  rig.hardware.imu.rate = {500, 0, 0};
  rig.pc.say(ArmAction::self_test);
  rig.run(4 * second);
  rig.hardware.imu.rate = {};
  rig.run(8 * second);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::passed);
}

TEST(SelfTest, FailsWhenTheRocketMovesWhileTheCanardsDo) {
  BoardRig rig;
  rig.pc.say(ArmAction::self_test);
  rig.run(4 * second);
  ASSERT_EQ(rig.pc.heard<ArmReply>()->canard, 0U);
  rig.hardware.imu.rate = {0, 500, 0};
  rig.run(100 * millisecond);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->failure, SelfTestFailure::moved);
}

TEST(SelfTest, FailsWithoutAGyro) {
  BoardRig rig;
  rig.run(4 * second);
  rig.sensors_work = false;
  rig.run(100 * millisecond);
  expect_failure(rig, SelfTestFailure::gyro_failed);
}

TEST(SelfTest, FailsWhenTheSecondAccelerometerIsSilent) {
  BoardRig rig;
  rig.hardware.accelerometer.status = hal::Status::no_reading;
  expect_failure(rig, SelfTestFailure::accelerometer_failed);
}

TEST(SelfTest, APlanForOneAccelerometerDoesNotAskTheOther) {
  core::FlightPlan plan = core::default_plan();
  plan.launch_detection.accelerometers = core::AccelerometerRule::one;
  BoardRig rig{plan};
  rig.hardware.accelerometer.status = hal::Status::no_reading;
  EXPECT_EQ(outcome(rig).self_test, SelfTestState::passed);
}

TEST(SelfTest, FailsWhenAnAccelerometerIsOffByMoreThanATenthOfOneG) {
  for (const std::int16_t counts : {std::int16_t{890}, std::int16_t{1110}}) {
    BoardRig rig;
    rig.hardware.accelerometer.specific_force = {counts, 0, 0};
    expect_failure(rig, SelfTestFailure::specific_force_not_one_g);
  }
  for (const std::int16_t counts : {std::int16_t{910}, std::int16_t{1090}}) {
    BoardRig rig;
    rig.hardware.accelerometer.specific_force = {counts, 0, 0};
    EXPECT_EQ(outcome(rig).self_test, SelfTestState::passed) << counts;
  }
}

TEST(SelfTest, FailsWhenTheRocketLiesOnItsSide) {
  BoardRig rig;
  rig.hardware.imu.specific_force = rig.hardware.accelerometer.specific_force = {0, 1000, 0};
  expect_failure(rig, SelfTestFailure::specific_force_not_one_g);
}

TEST(SelfTest, FailsWhenTheAccelerometersDisagreeByMoreThanThePlanAllows) {
  core::FlightPlan plan = core::default_plan();
  plan.launch_detection.disagreement_m_s2 = 0.15F * core::standard_gravity_m_s2;
  for (const bool disagree : {true, false}) {
    BoardRig rig{plan};
    rig.hardware.imu.specific_force = {1080, 0, 0};
    rig.hardware.accelerometer.specific_force = {static_cast<std::int16_t>(disagree ? 920 : 940), 0, 0};
    EXPECT_EQ(outcome(rig).failure, disagree ? SelfTestFailure::accelerometers_disagree : SelfTestFailure::none);
  }
}

TEST(SelfTest, NamesACanardThatDoesNotMove) {
  for (std::size_t canard = 0; canard < 4; ++canard) {
    BoardRig rig;
    rig.jammed[canard] = true;
    expect_failure(rig, SelfTestFailure::canard_did_not_follow, canard);
  }
}

TEST(SelfTest, NamesACanardThatStandsOffItsTrim) {
  BoardRig rig;
  rig.horn_off_deg[2] = 2.5;
  expect_failure(rig, SelfTestFailure::canard_did_not_follow, 2);
}

TEST(SelfTest, NamesAnEncoderThatIsSilent) {
  BoardRig rig;
  rig.unplugged[3] = true;
  expect_failure(rig, SelfTestFailure::encoder_silent, 3);
}

TEST(SelfTest, NamesTheOtherCanardWhereTwoServosAreSwapped) {
  BoardRig rig;
  rig.driven_by = {0, 2, 1, 3};
  expect_failure(rig, SelfTestFailure::another_canard_moved, 2);
}

TEST(SelfTest, FailsWhenTheFlashDoesNotAnswer) {
  BoardRig rig;
  rig.flash.set_answers(false);
  rig.power_cycle();
  expect_failure(rig, SelfTestFailure::flash_failed);
}

TEST(SelfTest, FailsWhenThePlanInTheFlashIsBroken) {
  BoardRig rig;
  // Where the first slot lies, something that is no plan.
  for (std::size_t i = 0; i < 64; ++i) {
    rig.flash.cells()[i] = std::byte{0x5A};
  }
  rig.power_cycle();
  expect_failure(rig, SelfTestFailure::no_valid_plan);
}

TEST(SelfTest, FailsWhenTheFlashIsNotEmptyEnoughForAFlight) {
  BoardRig rig;
  // A flight by the default plan needs more than this small flash has, so all of it must be blank.
  rig.flash.cells()[rig.flash.cells().size() - 4096] = std::byte{0};
  rig.power_cycle();
  expect_failure(rig, SelfTestFailure::flash_too_full);
}

TEST(SelfTest, AFlightNeedsRoomForItsControlTimeAndThirtySecondsMore) {
  core::FlightPlan plan = core::default_plan();
  plan.run.control_time = 30 * second;
  EXPECT_EQ(SelfTest::record_bytes(plan), 80'000U * 61U);
}

/// A self-test that is asked for is refused, and the result of the last one stays what it was.
void expect_refusal(BoardRig& rig, protocol::ArmRefusal refusal) {
  const ArmReply before = rig.pc.heard<ArmReply>().value_or(ArmReply{});
  rig.pc.say(ArmAction::self_test);
  rig.run(second);
  const ArmReply after = rig.pc.heard<ArmReply>().value();
  EXPECT_EQ(after.refusal, refusal);
  EXPECT_EQ(after.self_test, before.self_test);
  EXPECT_EQ(after.failure, before.failure);
  EXPECT_EQ(after.canard, before.canard);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
}

TEST(SelfTest, IsRefusedWhileTheBenchHoldsTheCanards) {
  BoardRig rig;
  rig.open_session();
  expect_refusal(rig, protocol::ArmRefusal::session_open);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::not_run);
}

TEST(SelfTest, IsRefusedToAnArmedRocket) {
  BoardRig rig;
  ASSERT_EQ(rig.arm().phase, core::Phase::armed);
  expect_refusal(rig, protocol::ArmRefusal::not_safe);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::passed);
}

TEST(SelfTest, ARefusedRequestDoesNotVoidAPassThatStillArms) {
  BoardRig rig;
  rig.make_ready();
  rig.open_session();
  expect_refusal(rig, protocol::ArmRefusal::session_open);
  rig.heartbeat.reset();
  rig.run(200 * millisecond);
  rig.pc.say(ArmAction::begin);
  rig.tick();
  EXPECT_TRUE(rig.pc.heard<ArmReply>()->nonce);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, protocol::ArmRefusal::none);
}

TEST(SelfTest, ARefusedRequestDoesNotHideWhichCanardFailed) {
  BoardRig rig;
  rig.jammed[2] = true;
  expect_failure(rig, SelfTestFailure::canard_did_not_follow, 2);
  rig.hardware.board.faults.add(hal::BoardFault::encoder_silent);
  rig.run(10 * millisecond);
  expect_refusal(rig, protocol::ArmRefusal::board_fault);
}

TEST(SelfTest, CanBeAskedForAgainAfterItFailed) {
  BoardRig rig;
  rig.jammed[0] = true;
  ASSERT_EQ(outcome(rig).self_test, SelfTestState::failed);
  rig.jammed[0] = false;
  rig.run(second);
  EXPECT_EQ(outcome(rig).self_test, SelfTestState::passed);
}

}  // namespace
}  // namespace fantail::avionics
