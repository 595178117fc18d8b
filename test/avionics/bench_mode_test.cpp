// SPDX-License-Identifier: MIT

#include "avionics/board_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using namespace core::literals;
using protocol::SessionAction;
using protocol::SessionReason;
using protocol::SessionState;

protocol::BenchRequest ask(core::Angle angle) { return {.angle = {angle, angle, angle, angle}}; }

TEST(BenchMode, AnOpenSessionMovesTheCanardsWhereItAsks) {
  BoardRig rig;
  rig.open_session();
  ASSERT_EQ(rig.pc.heard<protocol::SessionReply>()->state, SessionState::open);
  rig.pc.say(protocol::BenchRequest{.angle = {5_deg, std::nullopt, -4_deg, std::nullopt}});
  rig.run(second);
  EXPECT_NEAR(rig.commanded_deg(0), 5.0, 0.01);
  EXPECT_NEAR(rig.commanded_deg(1), 0.0, 0.01);
  EXPECT_NEAR(rig.commanded_deg(2), -4.0, 0.01);
  EXPECT_NEAR(rig.commanded_deg(3), 0.0, 0.01);
}

TEST(BenchMode, ACanardThatIsNotAskedStaysAtItsTrim) {
  core::FlightPlan plan = core::default_plan();
  plan.canards.each[1].trim = 1.5_deg;
  BoardRig rig{plan};
  rig.open_session();
  rig.pc.say(protocol::BenchRequest{.angle = {5_deg, std::nullopt, std::nullopt, std::nullopt}});
  rig.run(second);
  EXPECT_NEAR(rig.commanded_deg(1), 1.5, 0.01);
}

TEST(BenchMode, WithoutASessionARequestMovesNothingAndIsCountedAsStale) {
  BoardRig rig;
  rig.run(3 * second);
  rig.pc.say(ask(5_deg));
  rig.run(100 * millisecond);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  EXPECT_EQ(rig.rejected(protocol::Rejection::stale), 1);
}

TEST(BenchMode, ARequestBeyondThePlanLimitIsClampedAndReportedForThatCanard) {
  BoardRig rig;  // the default plan's limit is 9 degrees
  rig.open_session();
  rig.pc.say(protocol::BenchRequest{.angle = {12_deg, 8_deg, std::nullopt, std::nullopt}});
  rig.run(second);
  EXPECT_NEAR(rig.commanded_deg(0), 9.0, 0.01);
  EXPECT_NEAR(rig.commanded_deg(1), 8.0, 0.01);
  const std::array<bool, 4> limited{true, false, false, false};
  EXPECT_EQ(rig.pc.heard<protocol::StatusReport>()->limited, limited);
}

TEST(BenchMode, TheFirstMotionGoesSlowlyFromWhereTheEncoderSaysTheCanardIs) {
  BoardRig rig;
  rig.shaft_deg.fill(6.0);  // as the last user left them
  rig.tick();
  EXPECT_NEAR(rig.commanded_deg(0), 6.0, 0.05);
  rig.run(100 * millisecond);  // at 30 deg/s
  EXPECT_NEAR(rig.commanded_deg(0), 3.0, 0.05);
}

TEST(BenchMode, ItIsRefusedToARocketThatMoves) {
  BoardRig rig;
  rig.run(3 * second);
  rig.hardware.imu.rate = {500, 0, 0};
  rig.run(10 * millisecond);
  rig.pc.say(protocol::BenchSession{.action = SessionAction::open, .session = 3});
  rig.tick();
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->state, SessionState::closed);
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->reason, SessionReason::not_at_rest);
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->session, 3);
}

TEST(BenchMode, ItEndsWhenTheRocketIsPickedUpAndTheCanardsCentre) {
  BoardRig rig;
  rig.open_session();
  rig.pc.say(ask(5_deg));
  rig.run(second);
  rig.hardware.imu.rate = {500, 0, 0};
  rig.run(3 * millisecond);
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->reason, SessionReason::not_at_rest);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
}

TEST(BenchMode, ItIsRefusedToAnArmedRocket) {
  BoardRig rig;
  ASSERT_EQ(rig.arm().phase, core::Phase::armed);
  rig.pc.say(protocol::BenchSession{.action = SessionAction::open, .session = 3});
  rig.tick();
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->reason, SessionReason::not_safe);
  rig.pc.say(ask(5_deg));
  rig.run(second);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
}

TEST(BenchMode, TheRightIsLostAHundredMillisecondsAfterTheLastHeartbeat) {
  BoardRig rig;
  rig.open_session();
  rig.pc.say(ask(5_deg));
  rig.run(second);
  const Microseconds last_heartbeat = rig.hardware.time - Microseconds{(rig.hardware.time.count() - 1'000) % 20'000};
  rig.heartbeat.reset();
  while (rig.hardware.time < last_heartbeat + 100 * millisecond) {
    rig.tick();
    ASSERT_TRUE(rig.all_pulses_are(5.0)) << rig.hardware.time.count();
  }
  rig.tick();
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->reason, SessionReason::heartbeat_lost);
}

TEST(BenchMode, ARequestIsNoHeartbeat) {
  BoardRig rig;
  rig.open_session();
  rig.heartbeat.reset();
  for (int i = 0; i < 50; ++i) {
    rig.pc.say(ask(5_deg));
    rig.run(10 * millisecond);
  }
  EXPECT_TRUE(rig.all_pulses_are(0.0));
}

TEST(BenchMode, ClosingCentresTheCanards) {
  BoardRig rig;
  rig.open_session(9);
  rig.pc.say(ask(5_deg));
  rig.run(second);
  rig.heartbeat.reset();
  rig.pc.say(protocol::BenchSession{.action = SessionAction::close, .session = 9});
  rig.tick();
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->reason, SessionReason::closed_by_bench);
}

TEST(BenchMode, ASecondBenchIsRefusedAndTheFirstKeepsItsSession) {
  BoardRig rig;
  rig.open_session(7);
  rig.pc.say(ask(5_deg));
  rig.pc.say(protocol::BenchSession{.action = SessionAction::open, .session = 8});
  rig.tick();
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->reason, SessionReason::other_session);
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->session, 8);
  rig.run(second);
  EXPECT_TRUE(rig.all_pulses_are(5.0));
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->state, SessionState::open);
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->session, 7);
}

TEST(BenchMode, AHeartbeatOfAnotherSessionKeepsNothingAliveAndIsCountedAsStale) {
  BoardRig rig;
  rig.open_session(7);
  rig.heartbeat = 8;
  rig.run(300 * millisecond);
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->reason, SessionReason::heartbeat_lost);
  rig.heartbeat.reset();
  EXPECT_EQ(rig.rejected(protocol::Rejection::stale), 15);
}

TEST(BenchMode, AFrameWithABadChecksumIsCountedAndMovesNothing) {
  BoardRig rig;
  rig.open_session();
  protocol::BusFrame frame = encode(ask(5_deg), 0, rig.pc.session);
  frame.data[0] ^= 1U;
  rig.pc.send(frame);
  rig.run(second);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  EXPECT_EQ(rig.rejected(protocol::Rejection::wrong_crc), 1);
}

TEST(BenchMode, AfterALostFrameTheNextOneIsRefusedAndTheOneAfterThatObeyed) {
  BoardRig rig;
  rig.open_session();
  rig.pc.send(encode(ask(1_deg), 4, rig.pc.session));
  rig.tick();
  rig.pc.send(encode(ask(2_deg), 6, rig.pc.session));
  rig.tick();
  EXPECT_TRUE(rig.all_pulses_are(1.0));
  rig.pc.send(encode(ask(3_deg), 7, rig.pc.session));
  rig.tick();
  EXPECT_TRUE(rig.all_pulses_are(3.0));
  EXPECT_EQ(rig.rejected(protocol::Rejection::wrong_counter), 1);
}

TEST(BenchMode, ARepeatedFrameIsRefused) {
  BoardRig rig;
  rig.open_session();
  rig.pc.send(encode(ask(1_deg), 4, rig.pc.session));
  rig.pc.send(encode(ask(2_deg), 4, rig.pc.session));
  rig.tick();
  EXPECT_TRUE(rig.all_pulses_are(1.0));
}

TEST(BenchMode, ABenchThatBeginsAnewWithAnotherSessionIsHeardAtOnceWhateverItsCounters) {
  BoardRig rig;
  rig.open_session(7);
  rig.pc.send(encode(ask(1_deg), 4, 7));
  rig.tick();
  rig.pc.say(protocol::BenchSession{.action = SessionAction::close, .session = 7});
  rig.pc.send(encode(protocol::BenchSession{.action = SessionAction::open, .session = 8}, 13));
  rig.pc.send(encode(ask(2_deg), 11, 8));
  rig.tick();
  EXPECT_TRUE(rig.all_pulses_are(2.0));
}

// The last number that CRC-8 does not tell from 7 is found by trying; it stands for one of 256.
TEST(BenchMode, ANumberThatIsTooSimilarToTheOneBeforeIsRefusedAndTheSameOneIsNot) {
  std::uint16_t similar = 8;
  while (protocol::told_apart(7, similar)) {
    similar += 1;
  }
  BoardRig rig;
  rig.open_session(7);
  rig.heartbeat.reset();
  rig.pc.say(protocol::BenchSession{.action = SessionAction::close, .session = 7});
  rig.pc.say(protocol::BenchSession{.action = SessionAction::open, .session = similar});
  rig.tick();
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->reason, SessionReason::number_too_similar);
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->state, SessionState::closed);
  rig.pc.say(protocol::BenchSession{.action = SessionAction::open, .session = 7});
  rig.tick();
  EXPECT_EQ(rig.pc.heard<protocol::SessionReply>()->state, SessionState::open);
}

TEST(BenchMode, AFullFrameQueueCannotMakeATickEndless) {
  BoardRig rig;
  rig.run(second);
  for (int i = 0; i < 60; ++i) {
    rig.pc.send({.id = 0x7FF, .length = 0, .data = {}});
  }
  rig.tick();
  rig.pc.say(ask(1_deg));  // waits behind the others
  rig.run(3 * millisecond);
  EXPECT_EQ(rig.rejected(protocol::Rejection::unknown_id), 60);
  EXPECT_EQ(rig.rejected(protocol::Rejection::stale), 1);
}

}  // namespace
}  // namespace fantail::avionics
