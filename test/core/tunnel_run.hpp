// SPDX-License-Identifier: MIT
#pragma once

#include "core/autopilot.hpp"
#include "core/flight_plan_fields.hpp"
#include "test.hpp"

namespace fantail::core {

inline FlightPlan tunnel_plan() {
  FlightPlan plan = default_plan();
  plan.run.start = Start::tunnel;
  return plan;
}

/// A rocket in the tunnel, where control begins on command and nothing but the roll rate matters: under control, with
/// canards that stand at zero.
struct TunnelRun {
  FlightPlan plan;
  Autopilot law{plan};
  Inputs inputs{};

  explicit TunnelRun(const FlightPlan& flown = tunnel_plan()) : plan{flown} {
    inputs.arm_switch_closed = true;
    for (auto& sample : inputs.accelerometers) {
      sample = {.specific_force_m_s2 = {.x = standard_gravity_m_s2}, .quality = SampleQuality::valid};
    }
    inputs.gyro.quality = SampleQuality::valid;
    inputs.encoders.fill(Angle{});
    run(5000);
    inputs.arm_command = true;
    tick();
    inputs.arm_command = false;
    inputs.start_command = true;
    tick();
    inputs.start_command = false;
    EXPECT_EQ(law.phase(), Phase::controlling);
  }

  void wait(Microseconds time) {
    inputs.time += time;
    inputs.gyro.time = inputs.time;
    for (auto& sample : inputs.accelerometers) {
      sample.time = inputs.time;
    }
  }
  const TickRecord& tick(float rate_rad_s = 0.0F) {
    wait(tick_period);
    inputs.gyro.rate_rad_s.x = rate_rad_s;
    return law.step(inputs);
  }
  void run(int ticks, float rate_rad_s = 0.0F) {
    for (int i = 0; i < ticks; ++i) {
      tick(rate_rad_s);
    }
  }
  const TickRecord& resume(Microseconds gap, float rate_rad_s) {
    wait(gap);
    inputs.gyro.rate_rad_s.x = rate_rad_s;
    law.resume(inputs);
    return law.step(inputs);
  }
};

}  // namespace fantail::core
