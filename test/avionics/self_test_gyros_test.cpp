// SPDX-License-Identifier: MIT
#include <utility>

#include <gtest/gtest.h>

#include "avionics/self_test.hpp"
#include "avionics/self_test_rig.hpp"

namespace fantail::avionics {
namespace {

using protocol::ArmAction;
using protocol::ArmReply;
using protocol::SelfTestFailure;
using protocol::SelfTestState;

core::FlightPlan two_gyros() {
  core::FlightPlan plan = core::default_plan();
  plan.sensors.gyros = core::GyroRule::two_agree;
  return plan;
}

TEST(SelfTest, WithTwoGyrosThatAgreeItPasses) {
  BoardRig rig{two_gyros()};
  rig.hardware.second_imu_is_fitted = true;
  EXPECT_EQ(outcome(rig).self_test, SelfTestState::passed);
}

TEST(SelfTest, NamesTheGyroOfTwoThatFailed) {
  BoardRig not_fitted{two_gyros()};
  expect_failure(not_fitted, SelfTestFailure::second_gyro_failed);

  BoardRig second_silent{two_gyros()};
  second_silent.hardware.second_imu_is_fitted = true;
  second_silent.hardware.second_imu.status = hal::Status::error;
  expect_failure(second_silent, SelfTestFailure::second_gyro_failed);

  BoardRig first_silent{two_gyros()};
  first_silent.hardware.second_imu_is_fitted = true;
  first_silent.hardware.imu.status = hal::Status::error;
  expect_failure(first_silent, SelfTestFailure::gyro_failed);
}

// A count of the rig is 0.001 rad/s.
TEST(SelfTest, FailsWhenTheGyrosDisagreeByMoreThanThePlanAllows) {
  core::FlightPlan plan = two_gyros();
  plan.sensors.gyro_disagreement_rad_s = 0.012F;
  for (const bool disagree : {true, false}) {
    BoardRig rig{plan};
    rig.hardware.second_imu_is_fitted = true;
    rig.hardware.second_imu.rate = {static_cast<std::int16_t>(disagree ? 15 : 11), 0, 0};
    EXPECT_EQ(outcome(rig).failure, disagree ? SelfTestFailure::gyros_disagree : SelfTestFailure::none);
  }
}

// Half the plan's quiet rate is 17.5 counts; beyond 34.9 it is never at rest.
TEST(SelfTest, NamesAGyroWhoseZeroIsFurtherOffThanItsDataSheetAllows) {
  for (const auto& [counts, failure] :
       {std::pair{17, SelfTestFailure::none}, std::pair{18, SelfTestFailure::gyro_turns},
        std::pair{-44, SelfTestFailure::gyro_turns}}) {
    for (const std::size_t axis : {0U, 1U, 2U}) {
      BoardRig rig;
      rig.hardware.imu.rate[axis] = static_cast<std::int16_t>(counts);
      EXPECT_EQ(outcome(rig).failure, failure) << counts << " " << axis;
    }
  }
}

TEST(SelfTest, TwoGyrosThatAgreeOnATurnAreNoProofOfRest) {
  BoardRig rig{two_gyros()};
  rig.hardware.second_imu_is_fitted = true;
  rig.hardware.imu.rate = rig.hardware.second_imu.rate = {25, 0, 0};
  EXPECT_EQ(outcome(rig).failure, SelfTestFailure::gyro_turns);
  rig.hardware.imu.rate = {15, 0, 0};
  rig.hardware.second_imu.rate = {20, 0, 0};
  rig.run(5 * second);
  EXPECT_EQ(outcome(rig).failure, SelfTestFailure::second_gyro_turns);
}

TEST(SelfTest, ARocketInHandsHasMovedAndItsGyroIsNotBlamed) {
  BoardRig rig;
  rig.pc.say(ArmAction::self_test);
  for (int i = 0; i < 30; ++i) {
    rig.hardware.imu.rate = {static_cast<std::int16_t>(i % 2 == 0 ? 100 : -60), 0, 0};
    rig.run(second / 2);
  }
  EXPECT_EQ(rig.pc.heard<ArmReply>()->failure, SelfTestFailure::moved);
}

TEST(SelfTest, ASecondGyroThatFailsWhileTheCanardsMoveFailsIt) {
  BoardRig rig{two_gyros()};
  rig.hardware.second_imu_is_fitted = true;
  rig.pc.say(ArmAction::self_test);
  rig.run(5 * second);
  ASSERT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::running);
  rig.hardware.second_imu.status = hal::Status::no_reading;
  rig.run(second / 2);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->failure, SelfTestFailure::second_gyro_failed);
}

TEST(SelfTest, ASecondImuThatNoPlanAsksForIsNotRead) {
  BoardRig rig;
  rig.hardware.second_imu_is_fitted = true;
  rig.hardware.second_imu.rate = {20'000, 0, 0};
  EXPECT_EQ(outcome(rig).self_test, SelfTestState::passed);
  EXPECT_FALSE(rig.tick().gyro_vote);
}

}  // namespace
}  // namespace fantail::avionics
