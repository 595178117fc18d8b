// SPDX-License-Identifier: MIT
#include "bench/gate.hpp"

#include "core/flight_plan_fields.hpp"
#include "test.hpp"

namespace fantail::bench {
namespace {

std::string gate_of(core::DormantUntil until) {
  core::FlightPlan plan = core::default_plan();
  plan.dormancy = {.until = until,
                   .height_m = 1523.5F,
                   .burn_time = core::Microseconds{3'100'000},
                   .burn_clock_factor = 1.1F,
                   .scale_error = 0.01F,
                   .bias_error_m_s2 = 0.6F};
  return gate(plan);
}

TEST(Gate, EachIsNamedWithItsNumbers) {
  using enum core::DormantUntil;
  EXPECT_EQ(gate_of(guide), "clear of the guide");
  EXPECT_EQ(gate_of(burn_out), "burn-out, at least 3.41 s after first thrust");
  EXPECT_EQ(gate_of(max_dynamic_pressure), "past the largest dynamic pressure");
  EXPECT_EQ(gate_of(height), "1523.5 m above the launch site");
  EXPECT_EQ(gate_of(burn_out_and_height),
            "burn-out, at least 3.41 s after first thrust, and 1523.5 m above the launch site");
  EXPECT_EQ(gate_of(max_dynamic_pressure_and_height),
            "past the largest dynamic pressure, and 1523.5 m above the launch site");
}

TEST(Gate, APlanForTheTunnelHasTheStartCommand) {
  core::FlightPlan plan = core::default_plan();
  plan.run.start = core::Start::tunnel;
  EXPECT_EQ(gate(plan), "the start command in the tunnel");
}

}  // namespace
}  // namespace fantail::bench
