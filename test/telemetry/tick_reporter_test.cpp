// SPDX-License-Identifier: MIT
#include "telemetry/tick_reporter.hpp"

#include "telemetry/collected.hpp"
#include "test.hpp"

namespace fantail::telemetry {
namespace {

using core::Angle;
using test::Collected;

core::TickRecord tick(std::int64_t number) {
  core::TickRecord record;
  record.time = core::Microseconds{1000 * number};
  return record;
}

TEST(TickReporter, TheStateIsTheRecordFieldByField) {
  core::TickRecord record;
  record.phase = core::Phase::controlling;
  record.reason = core::PhaseReason::guide_clear;
  record.command_status = core::CommandStatus::controlling;
  record.timing_fault = true;
  record.saturated = true;
  record.motion.roll_angle = Angle::from_radians(0.5F);
  record.motion.roll_rate_rad_s = 0.25F;
  record.reference = Angle::from_radians(0.125F);
  record.excitation = Angle::from_radians(1.5F);
  record.unclamped_command = Angle::from_radians(2.5F);
  record.command = Angle::from_radians(3.5F);
  record.motion.specific_force_m_s2 = {.x = 10.5F, .y = 1.0F, .z = 2.0F};
  record.motion.height_m = 100.5F;
  record.motion.speed_m_s = 50.5F;
  record.motion.vertical_speed_m_s = 40.5F;
  record.motion.tilt = Angle::from_radians(0.75F);
  EXPECT_EQ(state_of(record), (State{.phase = core::Phase::controlling,
                                     .reason = core::PhaseReason::guide_clear,
                                     .command_status = core::CommandStatus::controlling,
                                     .timing_fault = true,
                                     .saturated = true,
                                     .roll_angle_rad = 0.5,
                                     .roll_rate_rad_s = 0.25,
                                     .reference_rad = 0.125,
                                     .excitation_rad = 1.5,
                                     .unclamped_command_rad = 2.5,
                                     .command_rad = 3.5,
                                     .specific_force_m_s2 = 10.5,
                                     .height_m = 100.5,
                                     .speed_m_s = 50.5,
                                     .vertical_speed_m_s = 40.5,
                                     .tilt_rad = 0.75}));
}

TEST(TickReporter, ACanardThatIsNotDrivenOrNotReadHasNoAngle) {
  core::TickRecord record;
  record.canards[0] = {.angle = Angle::from_radians(0.5F), .pulse_us = 1500.0F, .driven = true, .limited = true};
  record.canards[1] = {.angle = Angle::from_radians(0.25F), .pulse_us = 0.0F, .driven = false, .limited = false};
  record.encoders[0] = Angle::from_radians(0.125F);
  record.verdicts[1] = core::CanardVerdict::dead;
  const Canards canards = canards_of(record, {0.75, {}, {}, {}});
  EXPECT_EQ(canards.command_rad, (Limits{0.5, {}, {}, {}}));
  EXPECT_EQ(canards.encoder_rad, (Limits{0.125, {}, {}, {}}));
  EXPECT_EQ(canards.limit_rad, (Limits{0.75, {}, {}, {}}));
  EXPECT_EQ(canards.limited, (Each<bool>{true, false, false, false}));
  EXPECT_EQ(canards.verdicts[1], core::CanardVerdict::dead);
  EXPECT_EQ(canards.canard_rad, std::nullopt);
}

// The smallest of plan limit, hard limit and mechanical stop.
TEST(TickReporter, LimitsAreThoseOfThePlan) {
  core::FlightPlan plan{};
  plan.controller.canard_limit = Angle::from_radians(0.125F);
  for (auto& canard : plan.canards.each) {
    canard.mechanical_stop = Angle::from_radians(0.25F);
  }
  plan.canards.each[2].mechanical_stop = Angle::from_radians(0.0625F);
  EXPECT_EQ(limits_of(plan), (Limits{0.125, 0.125, 0.0625, 0.125}));
}

TEST(TickReporter, ASecondIsAHundredStatesAHundredCanardsAndTenHealths) {
  Collected collected;
  TickReporter reporter{collected};
  for (std::int64_t i = 0; i < 1000; ++i) {
    reporter.report(tick(i));
  }
  EXPECT_EQ(collected.all<State>().size(), 100U);
  EXPECT_EQ(collected.all<Canards>().size(), 100U);
  EXPECT_EQ(collected.all<Health>().size(), 10U);
  EXPECT_EQ(collected.all<Event>().size(), 0U);
  const auto stamps = collected.stamps(Channel::state);
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    EXPECT_EQ(stamps[i].sequence, static_cast<std::int64_t>(i));
    EXPECT_EQ(stamps[i].time.count(), 10'000 * static_cast<std::int64_t>(i));
    EXPECT_EQ(stamps[i].run, stamps[0].run);
  }
}

TEST(TickReporter, AChangeIsToldWithItsOwnTick) {
  Collected collected;
  TickReporter reporter{collected};
  for (std::int64_t i = 0; i < 100; ++i) {
    core::TickRecord record = tick(i);
    if (i >= 37) {
      record.phase = core::Phase::armed;
      record.reason = core::PhaseReason::armed_by_switch_and_command;
    }
    if (i >= 41 && i < 43) {
      record.verdicts[2] = core::CanardVerdict::stalled;
    }
    reporter.report(record);
  }
  const auto healthy_again =
      Event{.verdict = Event::VerdictChange{
                .canard = 2, .before = core::CanardVerdict::stalled, .verdict = core::CanardVerdict::healthy}};
  const auto stalled = Event{.verdict = Event::VerdictChange{.canard = 2, .verdict = core::CanardVerdict::stalled}};
  const auto armed = Event{.phase = Event::PhaseChange{.phase = core::Phase::armed,
                                                       .reason = core::PhaseReason::armed_by_switch_and_command}};
  EXPECT_EQ(collected.all<Event>(), (std::vector{armed, stalled, healthy_again}));
  const auto stamps = collected.stamps(Channel::event);
  EXPECT_EQ(stamps[0].time.count(), 37'000);
  EXPECT_EQ(stamps[1].time.count(), 41'000);
  EXPECT_EQ(stamps[2].time.count(), 43'000);
}

TEST(TickReporter, HealthTellsTheLongestTickSinceTheOneBefore) {
  Collected collected;
  TickReporter reporter{collected};
  for (std::int64_t i = 0; i <= 200; ++i) {
    reporter.report(tick(i), {.tick_s = i == 50 ? 0.5 : 0.25, .late_ticks = i});
  }
  const auto health = collected.all<Health>();
  ASSERT_EQ(health.size(), 3U);
  EXPECT_EQ(health[0].longest_tick_s, 0.25);
  EXPECT_EQ(health[1].longest_tick_s, 0.5);
  EXPECT_EQ(health[2].longest_tick_s, 0.25);
  EXPECT_EQ(health[2].late_ticks, 200);
  EXPECT_EQ(health[2].bus, std::nullopt);
}

}  // namespace
}  // namespace fantail::telemetry
