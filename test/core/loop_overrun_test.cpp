// SPDX-License-Identifier: MIT

#include "rocket.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

// A tick that comes too long after the one before it, at the same time, or before it.

constexpr double thrust_m_s2 = 40.0;

/// Under control, and then a tick this long after the last one.
Rocket with_a_tick_after(Microseconds since_the_last) {
  Rocket rocket{default_plan()};
  rocket.fly_to_control();
  rocket.inputs_changed_by([since_the_last](Inputs& inputs) { inputs.time += since_the_last - ms(1); });
  rocket.tick(thrust_m_s2);
  return rocket;
}

TEST(ClockFault, MoreThanFiveMillisecondsOrNoneOrATimeThatRunsBackwardsEndsControl) {
  for (const auto us : std::to_array<std::int64_t>({5'001, 6'000, 1'000'000, 0, -1, -1'000, -5'001, -3'600'000'000})) {
    const Rocket rocket = with_a_tick_after(Microseconds{us});
    rocket.expect(Phase::finished, PhaseReason::timing_fault);
    EXPECT_TRUE(rocket.record().timing_fault) << us;
    EXPECT_EQ(rocket.record().command, Angle{}) << us;
    for (const CanardCommand& canard : rocket.record().canards) {
      EXPECT_EQ(canard.angle, Angle{}) << us;
    }
  }
}

TEST(ClockFault, IsNoTickThatComesAMicrosecondOrFiveMillisecondsAfterTheOneBefore) {
  for (const auto us : std::to_array<std::int64_t>({1, 1'000, 5'000})) {
    const Rocket rocket = with_a_tick_after(Microseconds{us});
    rocket.expect(Phase::controlling, PhaseReason::guide_clear);
    EXPECT_FALSE(rocket.record().timing_fault) << us;
  }
}

// Control ticks that were due and did not come.

FlightPlan plan_that_allows(std::uint16_t overruns, FlightPlan plan = default_plan()) {
  plan.run.overrun_limit = overruns;
  return plan;
}

// The tick comes this long after the one before.
const TickRecord& tick_after(Rocket& rocket, int gap_ms, double acceleration_m_s2 = 0.0) {
  rocket.rig.advance(ms(gap_ms - 1), acceleration_m_s2, 0.0);
  return rocket.tick(acceleration_m_s2);
}

TEST(LoopOverrun, IsEveryMillisecondThatATickIsLateToTheNearestOne) {
  struct Case {
    std::int64_t gap_us;
    std::uint32_t overruns;
  };
  for (const Case& c : {Case{1, 0}, Case{1'000, 0}, Case{1'500, 0}, Case{1'501, 1}, Case{2'000, 1}, Case{2'500, 1},
                        Case{2'501, 2}, Case{5'000, 4}, Case{5'001, 4}, Case{1'000'000, 999}}) {
    Autopilot autopilot{default_plan()};
    EXPECT_EQ(autopilot.step({.time = Microseconds{77'000'000}}).overruns, 0U) << "the first tick is never late";
    EXPECT_EQ(autopilot.step({.time = Microseconds{77'000'000 + c.gap_us}}).overruns, c.overruns) << c.gap_us;
  }
}

TEST(LoopOverrun, IsNoTickThatComesTwiceOrTooSoon) {
  Autopilot autopilot{default_plan()};
  for (const std::int64_t time_us : {5'000, 5'000, 4'000, 4'400}) {
    EXPECT_EQ(autopilot.step({.time = Microseconds{time_us}}).overruns, 0U) << time_us;
  }
}

TEST(LoopOverrun, IsCountedFromTheFirstTickInEveryPhaseAndNeverForgotten) {
  Rocket rocket{default_plan()};
  rocket.run(ms(10));
  EXPECT_EQ(tick_after(rocket, 3).overruns, 2U);
  rocket.arm_on_pad();
  EXPECT_EQ(rocket.record().overruns, 2U);
  EXPECT_EQ(tick_after(rocket, 2).overruns, 3U);
  rocket.run_until_phase_changes(thrust_m_s2);
  rocket.run_until_phase_changes(thrust_m_s2);
  rocket.expect(Phase::controlling, PhaseReason::guide_clear);
  EXPECT_EQ(tick_after(rocket, 5, thrust_m_s2).overruns, 7U);
}

TEST(LoopOverrun, TheCountStaysAtItsEnd) {
  constexpr std::int64_t day_us = 86'400'000'000;
  Autopilot autopilot{default_plan()};
  for (std::int64_t day = 0; day <= 60; ++day) {  // 2^32 ms are 49.7 days
    autopilot.step({.time = Microseconds{day * day_us}});
  }
  EXPECT_EQ(autopilot.step({.time = Microseconds{61 * day_us}}).overruns, std::numeric_limits<std::uint32_t>::max());
}

TEST(LoopOverrun, AsManyAsThePlanAllowsAreNoFaultAndOneMoreEndsControl) {
  Rocket rocket{plan_that_allows(20)};
  rocket.fly_to_control();
  for (int i = 0; i < 5; ++i) {
    EXPECT_FALSE(tick_after(rocket, 5, thrust_m_s2).timing_fault);
    rocket.run(ms(10), thrust_m_s2);
  }
  EXPECT_EQ(rocket.record().overruns, 20U);
  rocket.run(ms(500), thrust_m_s2);
  rocket.expect(Phase::controlling, PhaseReason::guide_clear);
  EXPECT_TRUE(tick_after(rocket, 2, thrust_m_s2).timing_fault);
  rocket.expect(Phase::finished, PhaseReason::timing_fault);
  EXPECT_EQ(rocket.record().command, Angle{});
}

TEST(LoopOverrun, WhereThePlanAllowsNoneTheFirstOneEndsControl) {
  Rocket rocket{plan_that_allows(0)};
  rocket.fly_to_control();
  rocket.run(ms(500), thrust_m_s2);
  rocket.expect(Phase::controlling, PhaseReason::guide_clear);
  tick_after(rocket, 2, thrust_m_s2);
  rocket.expect(Phase::finished, PhaseReason::timing_fault);
}

TEST(LoopOverrun, TooManyInTheGuideAndControlNeverBegins) {
  Rocket rocket{plan_that_allows(3)};
  rocket.arm_on_pad();
  rocket.run_until_phase_changes(thrust_m_s2);
  rocket.expect(Phase::launched, PhaseReason::launch_detected);
  tick_after(rocket, 4, thrust_m_s2);
  rocket.expect(Phase::launched, PhaseReason::launch_detected);
  tick_after(rocket, 2, thrust_m_s2);
  rocket.expect(Phase::armed, PhaseReason::timing_fault_before_control);
}

// What a long wait on the pad has cost is not the flight's.
TEST(LoopOverrun, ThoseOfThePadDoNotCountAgainstTheFlight) {
  Rocket rocket{plan_that_allows(3)};
  rocket.arm_on_pad();
  for (int i = 0; i < 10; ++i) {
    tick_after(rocket, 3);
  }
  EXPECT_EQ(rocket.record().overruns, 20U);
  rocket.run(ms(3'000));
  rocket.run_until_phase_changes(thrust_m_s2);
  rocket.run_until_phase_changes(thrust_m_s2);
  tick_after(rocket, 4, thrust_m_s2);
  rocket.expect(Phase::controlling, PhaseReason::guide_clear);
  tick_after(rocket, 2, thrust_m_s2);
  rocket.expect(Phase::finished, PhaseReason::timing_fault);
}

TEST(LoopOverrun, InTheTunnelTheyCountFromTheStartOfControl) {
  Rocket rocket{plan_that_allows(3, tunnel_plan())};
  rocket.arm_on_pad();
  for (int i = 0; i < 10; ++i) {
    tick_after(rocket, 3);
  }
  rocket.run(ms(3'000));
  rocket.command_once([](Inputs& inputs) { inputs.start_command = true; });
  rocket.expect(Phase::controlling, PhaseReason::tunnel_start_command);
  tick_after(rocket, 4);
  rocket.expect(Phase::controlling, PhaseReason::tunnel_start_command);
  tick_after(rocket, 2);
  rocket.expect(Phase::finished, PhaseReason::timing_fault);
}

}  // namespace

}  // namespace fantail::core
