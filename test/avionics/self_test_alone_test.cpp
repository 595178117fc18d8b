// SPDX-License-Identifier: MIT
// The self-test without a board around it: a sound rocket, changed in one thing each, up to the first move of a canard.

#include "test.hpp"
#include "tested_rocket.hpp"

namespace fantail::avionics {
namespace {

using namespace alone;
using core::Angle;
using namespace core::literals;

TEST(SelfTestAlone, TakesThreeStillSecondsAndNineMovesOfFourTenths) {
  TestedRocket rocket;
  rocket.run(still_ticks - 1);
  EXPECT_FALSE(rocket.test.canard_request());
  rocket.tick();
  ASSERT_TRUE(rocket.test.canard_request());
  rocket.run(9 * move_ticks - 1);
  EXPECT_TRUE(rocket.test.running());
  rocket.tick();
  rocket.expect(SelfTestFailure::none);
}

TEST(SelfTestAlone, AsksForEachCanardAloneToItsSwingFromTrim) {
  TestedRocket rocket;
  rocket.plan.canards.each[1].trim = -1_deg;
  rocket.plan.controller.canard_limit = 3.5_deg;
  rocket.run(still_ticks);
  for (int move = 0; move < 9; ++move) {
    rocket.run(move_ticks - 1);
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      const bool its_turn = move % 2 == 1 && i == static_cast<std::size_t>(move / 2);
      const float expected_deg = (i == 1 ? -1.0F : 0.0F) + (its_turn ? (i == 1 ? 2.5F : 3.0F) : 0.0F);
      EXPECT_NEAR(rocket.test.canard_request().value()[i].degrees(), expected_deg, 1e-5F) << move << " " << i;
    }
    EXPECT_EQ(rocket.test.canard(), move == 0 ? 0U : static_cast<std::size_t>(move - 1) / 2);
    rocket.tick();
  }
  rocket.expect(SelfTestFailure::none);
}

TEST(SelfTestAlone, IsRefusedWithAReasonAndARunningOneGoesOn) {
  const auto refusal = [](const Situation& now, bool session_open) {
    const core::FlightPlan plan = core::default_plan();
    SelfTest test{plan};
    const auto result = test.start(now, session_open);
    EXPECT_EQ(test.running(), result == protocol::ArmRefusal::none);
    return result;
  };
  EXPECT_EQ(refusal({}, false), protocol::ArmRefusal::none);
  EXPECT_EQ(refusal({.phase = core::Phase::armed}, false), protocol::ArmRefusal::not_safe);
  EXPECT_EQ(refusal({}, true), protocol::ArmRefusal::session_open);
  EXPECT_EQ(refusal({.board_faulty = true}, false), protocol::ArmRefusal::board_fault);
  TestedRocket rocket;
  rocket.run(still_ticks);
  EXPECT_EQ(rocket.test.start({.time = rocket.inputs.time}, true), protocol::ArmRefusal::none);
  EXPECT_TRUE(rocket.test.canard_request()) << "it did not begin anew";
}

TEST(SelfTestAlone, PhaseAndBoardFaultEndIt) {
  TestedRocket rocket;
  rocket.run(100);
  rocket.record.phase = core::Phase::armed;
  rocket.tick();
  rocket.expect(SelfTestFailure::not_safe);
  TestedRocket faulty;
  faulty.board_faulty = true;
  faulty.tick();
  faulty.expect(SelfTestFailure::board_fault);
}

TEST(SelfTestAlone, WithoutAVoteAFailedGyroEndsItAtOnce) {
  TestedRocket rocket;
  rocket.record.motion.gyro = core::SensorState::failed;
  rocket.tick();
  rocket.expect(SelfTestFailure::gyro_failed);
}

TEST(SelfTestAlone, OfTwoGyrosTheOneIsNamedThatIsWithoutVoteForMoreThanATenthOfASecond) {
  for (const auto& [vote, failure] : {std::pair{core::GyroVote::first, SelfTestFailure::second_gyro_failed},
                                      std::pair{core::GyroVote::second, SelfTestFailure::gyro_failed},
                                      std::pair{core::GyroVote::disagree, SelfTestFailure::gyros_disagree},
                                      std::pair{core::GyroVote::neither, SelfTestFailure::gyro_failed}}) {
    TestedRocket rocket;
    rocket.record.motion.gyro = core::SensorState::failed;  // with a vote only the vote counts
    rocket.record.gyro_vote = core::GyroVote::both;
    rocket.run(500);
    rocket.record.gyro_vote = vote;
    rocket.run(100);
    EXPECT_TRUE(rocket.test.running());
    rocket.tick_at(Microseconds{600'001});
    rocket.expect(failure);
  }
}

TEST(SelfTestAlone, WhereTheWholeImuIsSilentItsGyroIsNamed) {
  for (const auto& [vote, failure] :
       {std::pair{std::optional{core::GyroVote::second}, SelfTestFailure::gyro_failed},
        std::pair{std::optional{core::GyroVote::neither}, SelfTestFailure::gyro_failed},
        std::pair{std::optional{core::GyroVote::first}, SelfTestFailure::accelerometer_failed},
        std::pair{std::optional<core::GyroVote>{}, SelfTestFailure::accelerometer_failed}}) {
    TestedRocket rocket{[](TestedRocket& r) { r.inputs.accelerometers[0].quality = core::SampleQuality::absent; }};
    rocket.record.gyro_vote = vote;
    rocket.run(static_cast<int>(rocket.plan.motion.stale_time / tick_time));
    EXPECT_TRUE(rocket.test.running());
    rocket.tick();
    rocket.expect(failure);
  }
}

TEST(SelfTestAlone, ASampleThatIsRepeatedNotFiniteOrAtTheEndOfItsRangeIsNone) {
  using Spoil = void (*)(core::AccelerometerSample&);
  for (const Spoil spoil :
       {Spoil{[](core::AccelerometerSample& s) { s.time = tested_from; }},
        Spoil{[](core::AccelerometerSample& s) { s.specific_force_m_s2.x = std::numeric_limits<float>::quiet_NaN(); }},
        Spoil{[](core::AccelerometerSample& s) { s.quality = core::SampleQuality::saturated; }}}) {
    for (const std::size_t which : {std::size_t{0}, std::size_t{1}}) {
      TestedRocket always{[&](TestedRocket& r) { spoil(r.inputs.accelerometers[which]); }};
      always.run(100).expect(SelfTestFailure::accelerometer_failed);
      TestedRocket now_and_then{[&](TestedRocket& r) {
        if (r.tested_for() / tick_time % 2 == 0) {
          spoil(r.inputs.accelerometers[which]);
        }
      }};
      now_and_then.run(whole_test).expect(SelfTestFailure::none);
    }
  }
}

TEST(SelfTestAlone, TheStillSecondsAreAtRestToo) {
  TestedRocket rocket{[](TestedRocket& r) {
    r.record.motion.at_rest_for = std::min(r.record.motion.at_rest_for, Microseconds{2'999'999});
  }};
  rocket.run(4'000);
  EXPECT_FALSE(rocket.test.canard_request());
  rocket.change = [](TestedRocket&) {};
  rocket.record.motion.at_rest_for = Microseconds{2'999'000};
  rocket.tick();
  EXPECT_TRUE(rocket.test.canard_request());
}

TEST(SelfTestAlone, MotionInTheStillSecondsBeginsThemAnew) {
  TestedRocket rocket;
  rocket.run(2'000);
  rocket.record.motion.at_rest_for = -tick_time;
  rocket.tick();
  ASSERT_EQ(rocket.record.motion.at_rest_for, Microseconds{});
  rocket.record.motion.at_rest_for = Microseconds{10'000'000};  // only the test's own seconds count from here on
  rocket.run(still_ticks - 1);
  EXPECT_FALSE(rocket.test.canard_request());
  rocket.tick();
  EXPECT_TRUE(rocket.test.canard_request());
}

TEST(SelfTestAlone, MotionForgetsWhatWasMeasuredInIt) {
  TestedRocket rocket{[](TestedRocket& r) {
    if (r.tested_for() < Microseconds{2'000'000}) {
      r.inputs.accelerometers[0].specific_force_m_s2.x = 30.0F;
    }
  }};
  rocket.run(1'999);
  rocket.record.motion.at_rest_for = -tick_time;
  rocket.run(1);
  rocket.record.motion.at_rest_for = Microseconds{10'000'000};
  rocket.run(whole_test).expect(SelfTestFailure::none);
}

TEST(SelfTestAlone, WaitsTwelveSecondsForTheFlashAndSaysSo) {
  for (const bool is_free : {true, false}) {
    for (const bool plan_is_known : {true, false}) {
      if (is_free && plan_is_known) {
        continue;
      }
      TestedRocket rocket;
      rocket.flash = is_free ? FlashFacts{.free_bytes = 100'000'000} : FlashFacts{};
      if (plan_is_known) {
        rocket.flash.plan = protocol::PlanSource::built_in;
      }
      rocket.run(11'999);
      rocket.tick_at(Microseconds{11'999'999});
      EXPECT_TRUE(rocket.test.running());
      rocket.tick_at(Microseconds{12'000'000});
      rocket.expect(SelfTestFailure::timed_out);
    }
  }
}

TEST(SelfTestAlone, OfARocketThatIsNeverStillTheSensorThatIsOffIsNamed) {
  TestedRocket moved{[](TestedRocket& r) { r.record.motion.at_rest_for = Microseconds{1}; }};
  moved.run(12'000).expect(SelfTestFailure::moved);
  TestedRocket off{[](TestedRocket& r) {
    r.record.motion.at_rest_for = Microseconds{1};
    r.inputs.accelerometers[1].specific_force_m_s2.x = 1.2F * core::standard_gravity_m_s2;
  }};
  off.run(12'000).expect(SelfTestFailure::specific_force_not_one_g);
  TestedRocket just_moved{[](TestedRocket& r) {
    r.record.motion.at_rest_for = Microseconds{0};  // nothing is averaged
    r.inputs.accelerometers[0].quality = core::SampleQuality::valid;
  }};
  just_moved.run(12'000).expect(SelfTestFailure::moved);
}

TEST(SelfTestAlone, OneSampleIsEnoughToNameASensor) {
  for (const auto& [factor, failure] :
       {std::pair{1.2F, SelfTestFailure::specific_force_not_one_g}, std::pair{1.0F, SelfTestFailure::moved}}) {
    TestedRocket rocket{[read_g = factor](TestedRocket& r) {
      const bool just_moved = r.tested_for() == Microseconds{11'999'000};
      r.record.motion.at_rest_for = Microseconds{just_moved ? 0 : 1};
      r.inputs.accelerometers[0].specific_force_m_s2.x = read_g * core::standard_gravity_m_s2;
    }};
    rocket.run(12'000).expect(failure);
  }
}

TEST(SelfTestAlone, APlanThatNeedsOneAccelerometerJudgesThatOne) {
  for (const std::size_t silent : {std::size_t{0}, std::size_t{1}}) {
    TestedRocket rocket{
        [=](TestedRocket& r) { r.inputs.accelerometers[silent].quality = core::SampleQuality::absent; }};
    rocket.plan.launch_detection.accelerometers = core::AccelerometerRule::one;
    rocket.run(whole_test);
    rocket.expect(silent == 0 ? SelfTestFailure::accelerometer_failed : SelfTestFailure::none);
  }
}

TEST(SelfTestAlone, AnAxialForceOffByATenthOfOneGIsBorneAndNotMore) {
  for (const float factor : {0.899F, 0.901F, 1.099F, 1.101F}) {
    for (const std::size_t which : {std::size_t{0}, std::size_t{1}}) {
      TestedRocket rocket{[&](TestedRocket& r) {
        r.inputs.accelerometers[which].specific_force_m_s2.x = factor * core::standard_gravity_m_s2;
      }};
      rocket.run(whole_test);
      rocket.expect(factor > 0.9F && factor < 1.1F ? SelfTestFailure::none : SelfTestFailure::specific_force_not_one_g);
    }
  }
}

TEST(SelfTestAlone, TwoAccelerometersMayDifferByWhatThePlanAllowsEitherWay) {
  for (const float apart_m_s2 : {0.99F, 1.01F, -0.99F, -1.01F}) {
    TestedRocket rocket{[&](TestedRocket& r) {
      r.inputs.accelerometers[0].specific_force_m_s2.x += 0.5F * apart_m_s2;
      r.inputs.accelerometers[1].specific_force_m_s2.x -= 0.5F * apart_m_s2;
    }};
    rocket.plan.launch_detection.disagreement_m_s2 = 1.0F;
    rocket.run(whole_test);
    rocket.expect(std::abs(apart_m_s2) < 1.0F ? SelfTestFailure::none : SelfTestFailure::accelerometers_disagree);
  }
}

TEST(SelfTestAlone, TwoAccelerometersMayDifferByExactlyWhatThePlanAllows) {
  for (const std::size_t more : {std::size_t{0}, std::size_t{1}}) {
    TestedRocket rocket{[=](TestedRocket& r) {
      r.inputs.accelerometers[more].specific_force_m_s2.x = 10.0F;
      r.inputs.accelerometers[1 - more].specific_force_m_s2.x = 9.0F;
    }};
    rocket.plan.launch_detection.disagreement_m_s2 = 1.0F;
    rocket.run(whole_test).expect(SelfTestFailure::none);
  }
}

TEST(SelfTestAlone, RoomIsNeededForWholeSecondsOfAFlightAndHalfAMinuteAfterIt) {
  core::FlightPlan plan = core::default_plan();
  plan.run.control_time = Microseconds{0};
  EXPECT_EQ(SelfTest::record_bytes(plan), 80'000U * 31U);
  plan.run.control_time = Microseconds{29'999'970};
  EXPECT_EQ(SelfTest::record_bytes(plan), 80'000U * 60U);
}

TEST(SelfTestAlone, TheFlashIsJudgedBeforeACanardMoves) {
  const auto judged = [](auto what) {
    TestedRocket rocket;
    what(rocket.flash);
    rocket.run(still_ticks);
    EXPECT_EQ(rocket.test.running(), rocket.test.failure() == SelfTestFailure::none);
    return rocket.test.failure();
  };
  EXPECT_EQ(judged([](FlashFacts& f) { f = {.failed = true}; }), SelfTestFailure::flash_failed);
  EXPECT_EQ(judged([](FlashFacts& f) { f.plan = protocol::PlanSource::stored; }), SelfTestFailure::none);
  EXPECT_EQ(judged([](FlashFacts& f) { f.plan = protocol::PlanSource::stored_is_broken; }),
            SelfTestFailure::no_valid_plan);
  EXPECT_EQ(judged([](FlashFacts& f) { f.plan = protocol::PlanSource::stored_is_newer; }), SelfTestFailure::newer_plan);
  const std::uint32_t needed = SelfTest::record_bytes(core::default_plan());
  EXPECT_EQ(judged([=](FlashFacts& f) { f.free_bytes = needed; }), SelfTestFailure::none);
  EXPECT_EQ(judged([=](FlashFacts& f) { f.free_bytes = needed - 1; }), SelfTestFailure::flash_too_full);
  EXPECT_EQ(judged([](FlashFacts& f) { f.free_bytes = f.region_bytes = 1'000; }), SelfTestFailure::none)
      << "a small flash that is blank";
}

}  // namespace
}  // namespace fantail::avionics
