// SPDX-License-Identifier: MIT
#include "gateway/gateway.hpp"

#include "avionics/can_frame.hpp"
#include "telemetry/collected.hpp"
#include "telemetry/tick_reporter.hpp"
#include "test.hpp"

namespace fantail::telemetry {
namespace {

using core::Angle;
using gateway::Gateway;
using gateway::ListenOnlyBus;
using hal::Microseconds;
using test::Collected;

class ScriptedBus final : public hal::CanBus {
 public:
  bool send(const hal::CanFrame& frame) override {
    sent.push_back(frame);
    return true;
  }
  std::optional<hal::CanFrame> receive() override {
    if (waiting.empty()) {
      return std::nullopt;
    }
    const hal::CanFrame frame = waiting.front();
    waiting.pop_front();
    return frame;
  }
  [[nodiscard]] hal::CanState state() const override { return hal::CanState::error_warning; }
  [[nodiscard]] hal::CanCounters counters() const override { return {.overrun = 7}; }

  std::deque<hal::CanFrame> waiting;
  std::vector<hal::CanFrame> sent;
};

class GatewayTest : public ::testing::Test {
 protected:
  template <typename Message>
  void say(const Message& message) {
    bus.waiting.push_back(avionics::can_frame(encode(message)));
  }
  void say_angles(float command_deg, float encoder_deg) {
    protocol::CommandReport commands;
    protocol::EncoderReport encoders;
    commands.angle[0] = Angle::from_degrees(command_deg);
    encoders.angle[0] = Angle::from_degrees(encoder_deg);
    bus.waiting.push_back(avionics::can_frame(encode(commands, counter)));
    bus.waiting.push_back(avionics::can_frame(encode(encoders, counter)));
    counter = static_cast<std::uint8_t>((counter + 1) % 16);
  }
  void heartbeat(std::uint32_t uptime_ms) { say(protocol::HeartbeatReport{.uptime_ms = uptime_ms}); }
  void motion(core::Phase phase, core::PhaseReason reason = core::PhaseReason::power_on) {
    say(protocol::StatusReport{.phase = phase, .reason = reason, .roll_command = Angle::from_degrees(3.0F)});
    say(protocol::MotionReport{
        .roll_angle = Angle::from_degrees(-20.0F), .roll_rate_rad_s = 0.5F, .height_m = 100.0F, .speed_m_s = 50.0F});
  }

  ScriptedBus bus;
  Collected collected;
  Gateway gateway{bus, collected};
  std::uint8_t counter = 0;
};

TEST_F(GatewayTest, SendsNothingBeforeItKnowsTheAvionicsTime) {
  motion(core::Phase::safe);
  gateway.listen(Microseconds{1'000});
  EXPECT_TRUE(collected.packets.empty());
  heartbeat(5'000);
  motion(core::Phase::safe);
  gateway.listen(Microseconds{2'000});
  const auto stamps = collected.stamps(Channel::state);
  ASSERT_EQ(stamps.size(), 1U);
  EXPECT_EQ(stamps[0].time, Microseconds{5'000'000});
  EXPECT_EQ(stamps[0].sequence, 0);
}

// The figures come in the steps of the bus: 0.1 deg of roll, others finer than asked for here.
TEST_F(GatewayTest, WhatNoFrameSaysStaysUnknown) {
  heartbeat(0);
  motion(core::Phase::controlling);
  gateway.listen(Microseconds{1'000});
  const auto states = collected.all<State>();
  ASSERT_EQ(states.size(), 1U);
  EXPECT_EQ(states[0].phase, core::Phase::controlling);
  EXPECT_NEAR(states[0].roll_angle_rad.value(), -0.34907, 1e-3);
  EXPECT_NEAR(states[0].roll_rate_rad_s.value(), 0.5, 1e-2);
  EXPECT_NEAR(states[0].command_rad.value(), 0.05236, 1e-3);
  EXPECT_NEAR(states[0].height_m.value(), 100.0, 0.5);
  EXPECT_NEAR(states[0].speed_m_s.value(), 50.0, 0.5);
  EXPECT_EQ(states[0].reference_rad, std::nullopt);
  EXPECT_EQ(states[0].excitation_rad, std::nullopt);
  EXPECT_EQ(states[0].unclamped_command_rad, std::nullopt);
  EXPECT_EQ(states[0].specific_force_m_s2, std::nullopt);
}

TEST_F(GatewayTest, WhatTheBoardSaysOfItselfIsUnderstoodAndNotPassedOn) {
  heartbeat(0);
  say(protocol::BoardReport{.faults = 1, .overruns = 3});
  gateway.listen(Microseconds{0});
  EXPECT_EQ(gateway.heard().frames, 2U);
  EXPECT_EQ(gateway.heard().damaged + gateway.heard().foreign, 0U);
  EXPECT_TRUE(collected.all<Health>().empty());
}

TEST_F(GatewayTest, AnOldPhaseIsNotSentBesideANewMotion) {
  heartbeat(0);
  motion(core::Phase::safe);
  gateway.listen(Microseconds{0});
  say(protocol::MotionReport{});
  gateway.listen(Microseconds{100'001});
  EXPECT_EQ(collected.all<State>().size(), 1U);
}

// A millisecond apart on the bus; a hundred a second are sent.
TEST_F(GatewayTest, CanardsAreThinnedOut) {
  heartbeat(0);
  for (int i = 0; i < 1'000; ++i) {
    say_angles(1.0F, 2.0F);
    gateway.listen(Microseconds{1'000 * i});
  }
  const auto canards = collected.all<Canards>();
  EXPECT_GE(canards.size(), 100U);
  EXPECT_LE(canards.size(), 112U);
  EXPECT_NEAR(canards[0].command_rad[0].value(), 0.017453, 1e-4);
  EXPECT_NEAR(canards[0].encoder_rad[0].value(), 0.034907, 1e-4);
  EXPECT_EQ(canards[0].command_rad[1], std::nullopt);
  EXPECT_EQ(canards[0].limit_rad[0], std::nullopt);
  EXPECT_EQ(canards[0].verdicts[0], std::nullopt);
  EXPECT_EQ(gateway.heard().lost, 0U);
}

TEST_F(GatewayTest, LimitsAndVerdictsAreAddedOnceTheyAreKnown) {
  heartbeat(0);
  protocol::LimitReport limits;
  limits.limit.fill(Angle::from_degrees(9.0F));
  say(limits);
  protocol::HealthReport health;
  health.verdicts[3] = core::CanardVerdict::slipping;
  say(health);
  say_angles(0.0F, 0.0F);
  gateway.listen(Microseconds{0});
  const auto canards = collected.all<Canards>();
  ASSERT_EQ(canards.size(), 1U);
  EXPECT_NEAR(canards[0].limit_rad[2].value(), 0.15708, 1e-3);
  EXPECT_EQ(canards[0].verdicts[3], core::CanardVerdict::slipping);
}

TEST_F(GatewayTest, AChangeIsAnEventAndHowItFoundThingsIsNone) {
  heartbeat(0);
  motion(core::Phase::armed);
  gateway.listen(Microseconds{0});
  EXPECT_TRUE(collected.all<Event>().empty());
  motion(core::Phase::launched, core::PhaseReason::launch_detected);
  gateway.listen(Microseconds{10'000});
  EXPECT_EQ(collected.all<Event>(),
            (std::vector{Event{.phase = Event::PhaseChange{.before = core::Phase::armed,
                                                           .phase = core::Phase::launched,
                                                           .reason = core::PhaseReason::launch_detected}}}));
}

TEST_F(GatewayTest, HealthHasBothEndsOfTheBusAndCountsOverTheWrap) {
  heartbeat(0);
  for (const auto unsent : {std::uint8_t{250}, std::uint8_t{4}}) {
    say(protocol::HealthReport{.gyro = core::SensorState::fresh,
                               .bus_state = 2,
                               .unsent = unsent,
                               .overrun = 1,
                               .bus_errors = 2,
                               .longest_tick_us = 450});
    gateway.listen(Microseconds{0});
  }
  const auto healths = collected.all<Health>();
  ASSERT_EQ(healths.size(), 2U);
  EXPECT_EQ(healths[1].bus,
            (Health::Bus{.state = hal::CanState::error_passive, .unsent = 260, .overrun = 1, .errors = 2}));
  EXPECT_NEAR(healths[1].longest_tick_s.value(), 450e-6, 1e-9);
  EXPECT_EQ(healths[1].late_ticks, std::nullopt);
  EXPECT_EQ(healths[1].gateway->state, hal::CanState::error_warning);
  EXPECT_EQ(healths[1].gateway->frames, 3);
  EXPECT_EQ(healths[1].gateway->overrun, 7);
}

TEST_F(GatewayTest, AnAvionicsThatWasSwitchedOnAgainIsAnotherRun) {
  heartbeat(60'000);
  motion(core::Phase::finished);
  gateway.listen(Microseconds{0});
  heartbeat(44);
  motion(core::Phase::safe);
  gateway.listen(Microseconds{5'000'000});
  const auto stamps = collected.stamps(Channel::state);
  ASSERT_EQ(stamps.size(), 2U);
  EXPECT_NE(stamps[0].run, stamps[1].run);
  EXPECT_EQ(stamps[1].sequence, 0);
  EXPECT_EQ(stamps[1].time, Microseconds{44'000});
  EXPECT_EQ(gateway.restarts(), 1);
  EXPECT_TRUE(collected.all<Event>().empty());
}

TEST_F(GatewayTest, NothingIsEverSaidOnTheBus) {
  heartbeat(0);
  motion(core::Phase::safe);
  say_angles(0.0F, 0.0F);
  bus.waiting.push_back({.id = 0x7E0, .length = 8});
  gateway.listen(Microseconds{0});
  ListenOnlyBus listening{bus};
  EXPECT_FALSE(listening.send({.id = 1}));
  EXPECT_TRUE(bus.sent.empty());
  EXPECT_EQ(gateway.heard().foreign, 1U);
}

TEST(LimitTap, HearsTheLimitsAndPassesEveryFrameOn) {
  ScriptedBus bus;
  LimitTap tap{bus};
  EXPECT_EQ(tap.limits_rad(), Limits{});
  protocol::LimitReport limits;
  limits.limit = {Angle::from_degrees(1.0F), Angle::from_degrees(2.0F), Angle::from_degrees(3.0F),
                  Angle::from_degrees(4.0F)};
  EXPECT_TRUE(tap.send(avionics::can_frame(encode(limits))));
  EXPECT_TRUE(tap.send({.id = 0x123}));
  EXPECT_EQ(bus.sent.size(), 2U);
  EXPECT_NEAR(tap.limits_rad()[3].value(), 0.069813, 1e-4);
}

}  // namespace
}  // namespace fantail::telemetry
