// SPDX-License-Identifier: MIT

#include "avionics/self_test.hpp"
#include "avionics/self_test_rig.hpp"
#include "test.hpp"
#include "tested_rocket.hpp"

namespace fantail::avionics {
namespace {

// The self-test without a board around it: while the canards move, and after it.

using namespace alone;
using core::Angle;
using namespace core::literals;

TEST(SelfTestAlone, WhatMovesWithoutBeingAskedIsNamed) {
  // Within a third of the swing of 3 degrees all is well.
  for (const auto& [off_deg, fails] : {std::pair{0.99F, false}, std::pair{1.01F, true}, std::pair{-1.01F, true}}) {
    TestedRocket rocket;
    rocket.run(still_ticks + move_ticks);  // the centre is over
    rocket.change = [&, off = off_deg](TestedRocket& r) { r.record.encoders[2] = Angle::from_degrees(off); };
    rocket.run(move_ticks);
    if (fails) {
      rocket.expect(SelfTestFailure::another_canard_moved, 2);
    } else {
      EXPECT_TRUE(rocket.test.running());
    }
  }
  TestedRocket at_centre{[](TestedRocket& r) { r.record.encoders[2] = 2_deg; }};
  at_centre.run(still_ticks + move_ticks).expect(SelfTestFailure::canard_did_not_follow, 2);
  TestedRocket in_turn{[](TestedRocket& r) { r.record.encoders[0] = Angle{}; }};
  in_turn.run(still_ticks + 2 * move_ticks).expect(SelfTestFailure::canard_did_not_follow, 0);
}

TEST(SelfTestAlone, EveryCanardIsWatchedWhileOneMovesThoseThatFollowItFirst) {
  for (const std::size_t wrong : {std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
    TestedRocket rocket;
    rocket.run(still_ticks + move_ticks);
    rocket.change = [=](TestedRocket& r) { r.record.encoders[wrong] = 2_deg; };
    rocket.run(move_ticks).expect(SelfTestFailure::another_canard_moved, wrong);
  }
  TestedRocket two;
  two.run(still_ticks + move_ticks);
  two.change = [](TestedRocket& r) { r.record.encoders[1] = r.record.encoders[3] = 2_deg; };
  two.run(move_ticks).expect(SelfTestFailure::another_canard_moved, 1);
  TestedRocket swapped;
  swapped.run(still_ticks + move_ticks);
  swapped.change = [](TestedRocket& r) { std::swap(r.record.encoders[0], r.record.encoders[2]); };
  swapped.run(move_ticks).expect(SelfTestFailure::another_canard_moved, 2);
}

TEST(SelfTestAlone, FromThreeToFourTenthsOfASecondEncodersAreReadToTheMicrosecond) {
  constexpr Microseconds moves_from{3'000'000};
  for (const Microseconds read : {Microseconds{299'999}, Microseconds{300'000}}) {
    TestedRocket rocket;
    rocket.run(still_ticks);
    rocket.change = [=](TestedRocket& r) {
      r.record.encoders[3].reset();
      if (r.tested_for() == moves_from + read) {
        r.record.encoders[3] = 3_deg / 3.0F;  // just within what is borne
      }
    };
    rocket.tick_at(moves_from + read);
    rocket.tick_at(moves_from + Microseconds{399'999});
    EXPECT_EQ(rocket.test.canard_request().value()[0], Angle{}) << "the centre is not over";
    rocket.tick_at(moves_from + Microseconds{400'000});
    if (read < Microseconds{300'000}) {
      rocket.expect(SelfTestFailure::encoder_silent, 3);
    } else {
      EXPECT_EQ(rocket.test.canard_request().value()[0], 3_deg);
    }
  }
}

TEST(SelfTestAlone, ACanardHasThreeTenthsOfASecondToArrive) {
  for (const int late : {300, 330}) {
    TestedRocket rocket;
    rocket.run(still_ticks + move_ticks);
    int ticks = 0;
    rocket.change = [&](TestedRocket& r) {
      if (++ticks < late) {
        r.record.encoders[0] = -30_deg;
      }
    };
    rocket.run(move_ticks);
    EXPECT_EQ(rocket.test.running(), late == 300) << late;
  }
}

TEST(SelfTestAlone, AnEncoderWithoutAReadingIsSilentAndOneThatReadsNowAndThenIsNot) {
  TestedRocket silent{[](TestedRocket& r) { r.record.encoders[3].reset(); }};
  silent.run(still_ticks + move_ticks).expect(SelfTestFailure::encoder_silent, 3);
  TestedRocket now_and_then{[](TestedRocket& r) {
    if (r.tested_for() / tick_time % 3 != 0) {
      r.record.encoders[3].reset();
    }
  }};
  now_and_then.run(whole_test).expect(SelfTestFailure::none);
  TestedRocket dead;
  dead.run(still_ticks);
  dead.record.verdicts[1] = core::CanardVerdict::dead;
  dead.tick();
  dead.expect(SelfTestFailure::encoder_silent, 1);
}

TEST(SelfTestAlone, MotionEndsItWhileTheCanardsMoveAndVoidsAPassOnThePad) {
  TestedRocket moving;
  moving.run(still_ticks + 10);
  moving.record.motion.at_rest_for = -tick_time;
  moving.tick();
  moving.expect(SelfTestFailure::moved);
  TestedRocket passed;
  passed.run(whole_test);
  passed.record.motion.at_rest_for = -tick_time;
  passed.tick();
  passed.expect(SelfTestFailure::moved);
  TestedRocket flown;
  flown.run(whole_test);
  flown.record.phase = core::Phase::launched;
  flown.record.motion.at_rest_for = -tick_time;
  flown.tick();
  EXPECT_EQ(flown.test.state(), SelfTestState::not_run);
  EXPECT_EQ(flown.test.failure(), SelfTestFailure::none);
}

TEST(SelfTestAlone, APassIsGoodForAMinuteToTheMicrosecond) {
  TestedRocket rocket;
  rocket.run(whole_test);
  EXPECT_TRUE(rocket.test.passed(rocket.inputs.time + Microseconds{60'000'000}));
  EXPECT_FALSE(rocket.test.passed(rocket.inputs.time + Microseconds{60'000'001}));
  EXPECT_FALSE(TestedRocket{}.test.passed(tested_from));
}

TEST(SelfTestAlone, AnotherOneBeginsWithoutWhatTheLastOneFound) {
  TestedRocket rocket;
  rocket.run(still_ticks);
  rocket.record.verdicts[1] = core::CanardVerdict::dead;
  rocket.tick();
  rocket.record.verdicts[1] = core::CanardVerdict::healthy;
  EXPECT_EQ(rocket.test.start({.time = rocket.inputs.time}, false), protocol::ArmRefusal::none);
  EXPECT_EQ(rocket.test.failure(), SelfTestFailure::none);
  EXPECT_FALSE(rocket.test.canard());
  rocket.run(still_ticks - 1);
  EXPECT_FALSE(rocket.test.canard_request()) << "it has its still seconds, too";
  rocket.run(whole_test - still_ticks + 1).expect(SelfTestFailure::none);
}

// On no pad is the air as thin as an MS5607 makes it, which was sold as an MS5611 and reads half: 542 hPa where the air
// of all weathers is thickest, 1 084 hPa. The Dead Sea has some 1 065 hPa, 4 000 m in a storm 585 hPa.
TEST(SelfTestAlone, RefusesABarometerWhosePressureIsThatOfNoLaunchSite) {
  for (const auto& [pressure_pa, failure] : {std::pair{101'325.0F, SelfTestFailure::none},
                                             {106'500.0F, SelfTestFailure::none},
                                             {58'500.0F, SelfTestFailure::none},
                                             {56'000.0F, SelfTestFailure::none},
                                             {55'999.0F, SelfTestFailure::barometer_failed},
                                             {54'200.0F, SelfTestFailure::barometer_failed},
                                             {101'325.0F / 2.0F, SelfTestFailure::barometer_failed},
                                             {112'000.0F, SelfTestFailure::barometer_failed}}) {
    TestedRocket rocket{[pressure_pa](TestedRocket& r) {
      r.record.barometer_state = core::BarometerState::on_pad;
      r.inputs.barometer.reset();
      if (r.tested_for() / tick_time % 10 == 0) {
        r.inputs.barometer = {.time = r.inputs.time, .pressure_pa = pressure_pa};
      }
    }};
    rocket.run(whole_test).expect(failure);
  }
  TestedRocket without;  // the plan asks for none
  without.run(whole_test).expect(SelfTestFailure::none);
}

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
