// SPDX-License-Identifier: MIT
// The self-test without a board around it: while the canards move, and after it.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tested_rocket.hpp"

namespace fantail::avionics {
namespace {

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

}  // namespace
}  // namespace fantail::avionics
