// SPDX-License-Identifier: MIT
// A tick that comes too long after the one before it, at the same time, or before it.
#include <array>
#include <cstdint>

#include <gtest/gtest.h>

#include "rocket.hpp"

namespace fantail::core {
namespace {

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

}  // namespace
}  // namespace fantail::core
