// SPDX-License-Identifier: MIT
// The abort input in whole flights: from the wire, through the debouncer, to the canards.

#include "flown_world.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

using core::Phase;
using core::PhaseReason;

constexpr double pressed_s = 2.0;    // after ignition, in the middle of control
constexpr double liftoff_s = 0.013;  // after ignition
constexpr double before_power_up_s = -60.0;

// 50 ticks at the new level, of which the first is that of the contact, and 1 ms to spare.
constexpr double longest_s = 0.051;

Fault abort_fault(Behaviour behaviour, double from_s, double on_s = 0.0, double off_s = 0.0) {
  return {
      .device = Device::abort_input, .how = behaviour, .from_s = from_s, .until_s = 60.0, .on_s = on_s, .off_s = off_s};
}

Scenario scenario_of(std::string_view input, const std::vector<Fault>& faults,
                     const std::vector<std::string>& changes = {}) {
  std::vector<std::string> all{"run.abort_input=" + std::string{input}};
  all.insert(all.end(), changes.begin(), changes.end());
  Scenario s = scenario("tasha3_launch2", all);
  s.faults = faults;
  return s;
}

FlownWorld fly_with(std::string_view input, const std::vector<Fault>& faults,
                    const std::vector<std::string>& changes = {}) {
  const Scenario s = scenario_of(input, faults, changes);
  return fly(s);
}

const Tick& end_of(const FlownWorld& flown) { return *flown.first_in(Phase::finished); }

constexpr std::array fitted{"open_aborts", "closed_aborts"};

TEST(AbortInput, OfAHealthyRocketDoesNotEndItsFlight) {
  for (const char* input : fitted) {
    EXPECT_EQ(end_of(fly_with(input, {})).record.reason, PhaseReason::apogee) << input;
  }
}

TEST(AbortInput, EndsControlAtTrimWithinFiftyOneMillisecondsOfTheContact) {
  for (const char* input : fitted) {
    const FlownWorld flown = fly_with(input, {abort_fault(Behaviour::pressed, pressed_s)});
    const double contact_s = pressed_s - liftoff_s;
    const Tick& end = end_of(flown);
    EXPECT_EQ(end.record.reason, PhaseReason::aborted) << input;
    EXPECT_GT(end.time_s, contact_s + 0.048) << input;
    EXPECT_LE(end.time_s, contact_s + longest_s) << input;
    for (const core::CanardCommand& canard : end.record.canards) {
      EXPECT_EQ(canard.angle, core::Angle{}) << input;
    }
    EXPECT_NEAR(flown.at(end.time_s + 0.3).truth.canard_rad / degree, 0.0, 0.1) << input;
  }
}

TEST(AbortInput, EndsALaunchThatHasNotClearedTheGuideAndADormantFlight) {
  const FlownWorld launched = fly_with("open_aborts", {abort_fault(Behaviour::pressed, 0.4)});
  EXPECT_EQ(launched.first_in(Phase::controlling), nullptr);
  EXPECT_EQ(end_of(launched).record.reason, PhaseReason::aborted);
  const FlownWorld dormant =
      fly_with("open_aborts", {abort_fault(Behaviour::pressed, pressed_s)}, {"dormancy.until=max_dynamic_pressure"});
  ASSERT_NE(dormant.first_in(Phase::dormant), nullptr);
  EXPECT_EQ(dormant.first_in(Phase::controlling), nullptr);
  EXPECT_EQ(end_of(dormant).record.reason, PhaseReason::aborted);
  EXPECT_LE(end_of(dormant).time_s, pressed_s - liftoff_s + longest_s);
}

TEST(AbortInput, ABrokenWireAbortsAsThePlanSays) {
  const std::vector<Fault> broken{abort_fault(Behaviour::dead, pressed_s)};
  EXPECT_EQ(end_of(fly_with("open_aborts", broken)).record.reason, PhaseReason::aborted);
  EXPECT_EQ(end_of(fly_with("closed_aborts", broken)).record.reason, PhaseReason::apogee);
}

TEST(AbortInput, AChatteringWireDoesNotAbort) {
  for (const char* input : fitted) {
    const FlownWorld flown = fly_with(input, {abort_fault(Behaviour::pressed, pressed_s, 0.049, 0.001)});
    EXPECT_EQ(end_of(flown).record.reason, PhaseReason::apogee) << input;
  }
}

TEST(AbortInput, WhatHasAskedIsNotClearedByChattering) {
  Scenario s = scenario_of("closed_aborts", {abort_fault(Behaviour::pressed, before_power_up_s),
                                             abort_fault(Behaviour::dead, -4.0, 0.049, 0.001)});
  World world{s};
  while (!world.over()) {
    ASSERT_EQ(world.tick().phase, Phase::safe);
    world.advance();
  }
  ASSERT_TRUE(world.refusal_to_arm());
  EXPECT_EQ(world.refusal_to_arm()->abort_input, protocol::AbortState::asks_to_abort);
}

protocol::ArmReply refusal_of(std::string_view input, const Fault& fault) {
  const Scenario s = scenario_of(input, {fault});
  World world{s};
  while (!world.over() && !world.refusal_to_arm()) {
    world.tick();
    world.advance();
  }
  return world.refusal_to_arm().value_or(protocol::ArmReply{});
}

TEST(AbortInput, AWireThatWasBrokenBeforePowerUpRefusesArmingByName) {
  const protocol::ArmReply reply = refusal_of("open_aborts", abort_fault(Behaviour::dead, before_power_up_s));
  EXPECT_EQ(reply.refusal, protocol::ArmRefusal::abort_not_ready);
  EXPECT_EQ(reply.abort_input, protocol::AbortState::asks_to_abort);
}

// Of such a contact nobody knows whether it could still abort.
TEST(AbortInput, OneThatChattersFromPowerUpOnRefusesArmingToo) {
  const protocol::ArmReply reply =
      refusal_of("open_aborts", abort_fault(Behaviour::pressed, before_power_up_s, 0.03, 0.03));
  EXPECT_EQ(reply.refusal, protocol::ArmRefusal::abort_not_ready);
  EXPECT_EQ(reply.abort_input, protocol::AbortState::unsettled);
}

// The contact is unknown for its first 50 ms after the reset.
TEST(AbortInput, AResetInFlightIsNoAbortAndTheInputWorksAgainAfterIt) {
  const Fault reset{.device = Device::processor, .how = Reset{}, .from_s = pressed_s};
  for (const char* input : fitted) {
    const FlownWorld resumed = fly_with(input, {reset});
    EXPECT_EQ(end_of(resumed).record.reason, PhaseReason::apogee) << input;
    const FlownWorld aborted = fly_with(input, {reset, abort_fault(Behaviour::pressed, pressed_s)});
    const Tick& end = end_of(aborted);
    EXPECT_EQ(end.record.reason, PhaseReason::aborted) << input;
    EXPECT_LE(end.time_s, pressed_s - liftoff_s + Reset{}.gap_s + longest_s) << input;
  }
}

}  // namespace
}  // namespace fantail::sim
