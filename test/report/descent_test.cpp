// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "report/verdict_parts.hpp"
#include "synthetic_flight.hpp"

namespace fantail::report {
namespace {

constexpr double g_m_s2 = 9.80665;

/// Two seconds of falling after an apogee at 10 s, a row a millisecond, with a pull from 10.5 s on.
flight::Flight falling(double pull_g, double pull_for_s) {
  flight::Flight flight = SyntheticFlight{}.flight;
  flight.events.apogee_s = 10.0;
  for (int i = 0; i < 2000; ++i) {
    const double time_s = 10.001 + 0.001 * i;
    const bool pulled = time_s >= 10.4995 && time_s < 10.4995 + pull_for_s;
    flight.rows.push_back({.time_s = time_s, .specific_force_m_s2 = (pulled ? pull_g : -0.9) * g_m_s2});
  }
  return flight;
}

TEST(JoltAfterApogee, IsWhereTheAccelerometerFeelsMoreThanOneAndAHalfG) {
  for (const double pull_g : {4.0, -4.0}) {
    const auto jolt = jolt_after_apogee(falling(pull_g, 0.3));
    ASSERT_TRUE(jolt);
    EXPECT_NEAR(jolt->time_s, 10.5, 1e-9);
    EXPECT_NEAR(jolt->specific_force_m_s2, 4.0 * g_m_s2, 1e-9);
  }
}

TEST(JoltAfterApogee, IsNoKnockAndNoFallThroughAir) {
  EXPECT_FALSE(jolt_after_apogee(falling(9.0, 0.015)));
  EXPECT_FALSE(jolt_after_apogee(falling(1.4, 0.5)));
}

// Of a rocket that turned over while its motor burned.
TEST(JoltAfterApogee, IsNotTheThrustOfAMotorThatStillBurns) {
  flight::Flight flight = falling(4.0, 0.3);
  flight.events.burnout_s = 10.9;
  EXPECT_FALSE(jolt_after_apogee(flight));
  flight.events.burnout_s = 3.0;
  EXPECT_TRUE(jolt_after_apogee(flight));
}

TEST(JoltAfterApogee, NeedsAnApogee) {
  flight::Flight flight = falling(4.0, 0.3);
  flight.events.apogee_s.reset();
  EXPECT_FALSE(jolt_after_apogee(flight));
  flight.phase_changes.push_back({.time_s = 10.1, .phase = core::Phase::finished, .reason = core::PhaseReason::apogee});
  EXPECT_TRUE(jolt_after_apogee(flight));
  flight.tunnel = true;
  EXPECT_FALSE(jolt_after_apogee(flight));
}

}  // namespace
}  // namespace fantail::report
