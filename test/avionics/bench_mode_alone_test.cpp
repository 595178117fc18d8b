// SPDX-License-Identifier: MIT

#include "avionics/arming.hpp"
#include "avionics/bench_mode.hpp"
#include "avionics/board_rig.hpp"
#include "core/flight_plan_fields.hpp"
#include "protocol/bus_codec.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

// The right to move the canards without a board around it.

using core::Microseconds;
using protocol::SessionAction;
using protocol::SessionReason;
using protocol::SessionState;
using namespace core::literals;

constexpr std::uint16_t first_session = 0x1234;

struct Bench {
  Situation now{.time = Microseconds{5'000'000}, .at_rest = true};
  BenchMode mode;

  bool say(SessionAction action, std::uint16_t session = first_session, bool self_test_runs = false) {
    return mode.receive(now, self_test_runs, {.action = action, .session = session});
  }
  void wait(std::int64_t us) {
    now.time += Microseconds{us};
    mode.update(now);
  }
};

TEST(BenchModeAlone, WithoutASessionNothingIsAskedOfACanard) {
  Bench bench;
  EXPECT_FALSE(bench.mode.receive(protocol::BenchRequest{.angle = {1_deg, 1_deg, 1_deg, 1_deg}}));
  EXPECT_FALSE(bench.mode.canard_request(core::default_plan().canards));
  bench.say(SessionAction::open);
  EXPECT_FALSE(bench.mode.canard_request(core::default_plan().canards)) << "nor by one that came before it";
  EXPECT_TRUE(bench.mode.receive(protocol::BenchRequest{.angle = {1_deg, 1_deg, 1_deg, 1_deg}}));
  EXPECT_TRUE(bench.mode.canard_request(core::default_plan().canards));
  bench.say(SessionAction::close);
  bench.say(SessionAction::open);
  EXPECT_FALSE(bench.mode.canard_request(core::default_plan().canards)) << "nor by one of the session before";
}

TEST(BenchModeAlone, KeepingAndClosingAreOfTheOpenSessionOnly) {
  Bench bench;
  EXPECT_FALSE(bench.say(SessionAction::keep));
  EXPECT_FALSE(bench.say(SessionAction::close));
  EXPECT_FALSE(bench.mode.take_news());
  EXPECT_TRUE(bench.say(SessionAction::open));
  EXPECT_EQ(bench.mode.session(), first_session);
  EXPECT_FALSE(bench.say(SessionAction::close, first_session + 1));
  EXPECT_TRUE(bench.mode.open());
  EXPECT_TRUE(bench.say(SessionAction::keep));
  EXPECT_TRUE(bench.say(SessionAction::close));
  EXPECT_FALSE(bench.mode.open());
  EXPECT_EQ(bench.mode.reply().reason, SessionReason::closed_by_bench);
}

TEST(BenchModeAlone, AnAnswerIsNewsOnce) {
  Bench bench;
  bench.say(SessionAction::open);
  EXPECT_EQ(bench.mode.reply().state, SessionState::open);
  EXPECT_EQ(bench.mode.reply().reason, SessionReason::opened);
  EXPECT_EQ(bench.mode.reply().session, first_session);
  EXPECT_TRUE(bench.mode.take_news());
  EXPECT_FALSE(bench.mode.take_news());
  bench.say(SessionAction::open);
  EXPECT_TRUE(bench.mode.take_news()) << "a bench that repeats itself has not heard it";
}

TEST(BenchModeAlone, SilenceOfAHundredMillisecondsIsBorneAndNotAMicrosecondMore) {
  for (const auto said : {SessionAction::open, SessionAction::keep}) {
    Bench bench;
    bench.say(SessionAction::open);
    bench.wait(60'000);
    bench.say(said);
    bench.wait(100'000);
    EXPECT_TRUE(bench.mode.open());
    bench.wait(1);
    EXPECT_FALSE(bench.mode.open());
    EXPECT_EQ(bench.mode.reply().reason, SessionReason::heartbeat_lost);
    EXPECT_EQ(bench.mode.reply().session, first_session);
  }
  Bench bench;
  bench.say(SessionAction::open);
  bench.wait(60'000);
  bench.say(SessionAction::keep, first_session + 1);
  bench.wait(40'001);
  EXPECT_FALSE(bench.mode.open()) << "another one's heartbeat";
}

TEST(BenchModeAlone, EachObjectionRefusesASessionAndLeavesTheStateAsItWas) {
  const auto refused = [](auto change, SessionReason expected, bool self_test_runs = false) {
    Bench bench;
    change(bench.now);
    EXPECT_TRUE(bench.say(SessionAction::open, first_session, self_test_runs));
    EXPECT_FALSE(bench.mode.open());
    EXPECT_FALSE(bench.mode.take_news());
    const auto refusal = bench.mode.take_refusal();
    ASSERT_TRUE(refusal);
    EXPECT_EQ(refusal->state, SessionState::closed);
    EXPECT_EQ(refusal->reason, expected);
    EXPECT_EQ(refusal->session, first_session);
    EXPECT_FALSE(bench.mode.take_refusal()) << "once";
  };
  refused([](Situation& now) { now.phase = core::Phase::armed; }, SessionReason::not_safe);
  refused([](Situation& now) { now.at_rest = false; }, SessionReason::not_at_rest);
  refused([](Situation&) {}, SessionReason::self_test_runs, true);
  Bench bench;
  bench.say(SessionAction::open);
  bench.say(SessionAction::open, first_session + 1);
  EXPECT_EQ(bench.mode.take_refusal()->reason, SessionReason::other_session);
  EXPECT_EQ(bench.mode.session(), first_session);
}

// Frames carry eight bits that are made of the session.
TEST(BenchModeAlone, ANumberThatFramesDoNotTellFromTheLastOneIsRefused) {
  std::uint16_t alike = first_session + 1;
  while (protocol::told_apart(first_session, alike)) {
    alike += 1;
  }
  Bench first;
  EXPECT_TRUE(first.say(SessionAction::open, alike));
  EXPECT_TRUE(first.mode.open()) << "there was no session before";
  Bench bench;
  bench.say(SessionAction::open);
  bench.say(SessionAction::close);
  bench.say(SessionAction::open, alike);
  EXPECT_FALSE(bench.mode.open());
  EXPECT_EQ(bench.mode.take_refusal()->reason, SessionReason::number_too_similar);
  bench.say(SessionAction::open);
  EXPECT_TRUE(bench.mode.open()) << "the same bench, which has begun anew";
  bench.say(SessionAction::close);
  bench.say(SessionAction::open, first_session + 1);
  EXPECT_EQ(bench.mode.session(), first_session + 1);
}

TEST(BenchModeAlone, EndsWithThePhaseAndWithMotion) {
  Bench armed;
  armed.say(SessionAction::open);
  armed.now.phase = core::Phase::armed;
  armed.wait(1);
  EXPECT_EQ(armed.mode.reply().reason, SessionReason::not_safe);
  EXPECT_FALSE(armed.mode.open());
  Bench moved;
  moved.say(SessionAction::open);
  moved.now.moves = true;
  moved.wait(1);
  EXPECT_EQ(moved.mode.reply().reason, SessionReason::not_at_rest);
  EXPECT_FALSE(moved.mode.open());
}

// Bench session, self-test and arming, where they meet.

using namespace core::literals;
using core::Phase;
using protocol::ArmAction;
using protocol::ArmRefusal;
using protocol::ArmReply;
using protocol::SelfTestState;
using protocol::SessionAction;
using protocol::SessionReason;

TEST(RightToMove, ASessionIsRefusedUntilTheRocketHasStoodForTheRestTime) {
  BoardRig rig;
  rig.run(1'900 * millisecond);  // of the default plan's 2 s
  rig.pc.say(protocol::BenchSession{.action = SessionAction::open, .session = 3});
  rig.tick();
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->reason, SessionReason::not_at_rest);
}

TEST(RightToMove, ASessionIsRefusedWhileTheSelfTestRuns) {
  BoardRig rig;
  rig.run(3 * second);
  rig.pc.say(ArmAction::self_test);
  rig.run(second);
  rig.pc.say(protocol::BenchSession{.action = SessionAction::open, .session = 3});
  rig.tick();
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->reason, SessionReason::self_test_runs);
  rig.run(6 * second);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::passed) << "and the test goes on";
}

TEST(RightToMove, ANewSessionDoesNotGoOnWithWhatTheLastOneAskedFor) {
  BoardRig rig;
  rig.open_session(7);
  rig.pc.say(protocol::BenchRequest{.angle = {5_deg, 5_deg, 5_deg, 5_deg}});
  rig.run(second);
  rig.pc.say(protocol::BenchSession{.action = SessionAction::close, .session = 7});
  rig.heartbeat.reset();
  rig.run(second);
  rig.open_session(8);
  rig.run(100 * millisecond);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
}

TEST(RightToMove, ASessionThatIsOpenedInTheTickOfTheConfirmationMovesNothing) {
  BoardRig rig;
  rig.pc.say(ArmAction::confirm, rig.begin_arming().value());
  rig.pc.say(protocol::BenchSession{.action = SessionAction::open, .session = 3});
  rig.pc.say(protocol::BenchRequest{.angle = {5_deg, 5_deg, 5_deg, 5_deg}});
  EXPECT_EQ(rig.tick().phase, Phase::armed);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  rig.tick();
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->reason, SessionReason::not_safe);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
}

TEST(RightToMove, ASelfTestThatIsAskedForInTheTickOfTheConfirmationDoesNotRun) {
  BoardRig rig;
  rig.pc.say(ArmAction::confirm, rig.begin_arming().value());
  rig.pc.say(ArmAction::self_test);
  EXPECT_EQ(rig.tick().phase, Phase::armed);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::failed) << "it was not refused: it had begun";
  EXPECT_EQ(rig.pc.heard<ArmReply>()->failure, protocol::SelfTestFailure::not_safe);
}

TEST(RightToMove, APlanWithALongRestTimeIsNotArmedBeforeIt) {
  core::FlightPlan plan = core::default_plan();
  plan.motion.rest_time = 10 * second;
  BoardRig rig{plan};
  rig.arm();  // eight seconds after power-up
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::passed);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::not_at_rest);
}

TEST(RightToMove, ControlInTheTunnelDoesNotStartWhileTheRocketMoves) {
  core::FlightPlan plan = core::default_plan();
  plan.run.start = core::Start::tunnel;
  BoardRig rig{plan};
  ASSERT_EQ(rig.arm().phase, Phase::armed);
  rig.hardware.imu.rate = {500, 0, 0};
  rig.run(10 * millisecond);
  rig.pc.say(ArmAction::start, rig.armed_with);
  EXPECT_EQ(rig.tick().phase, Phase::armed);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::not_at_rest);
}

TEST(RightToMove, ThereIsNoNonceBeforeThisPowerUpIsCounted) {
  Arming arming;
  const Situation open{.at_rest = true, .arm_switch_closed = false, .arm_switch_open = true};
  const Situation closed{.at_rest = true, .arm_switch_closed = true};
  arming.update(open);
  arming.receive(closed, {.self_test_passed = true, .power_up = {}}, {.action = ArmAction::begin});
  EXPECT_FALSE(arming.nonce());
  EXPECT_EQ(arming.refusal(), ArmRefusal::no_nonce);
  arming.receive(closed, {.self_test_passed = true, .power_up = 1}, {.action = ArmAction::begin});
  EXPECT_TRUE(arming.nonce());
}

}  // namespace

}  // namespace fantail::avionics
