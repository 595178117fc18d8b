// SPDX-License-Identifier: MIT
#pragma once

#include "core/dormancy_gate.hpp"
#include "core/flight_plan_fields.hpp"
#include "milliseconds.hpp"

namespace fantail::core {

inline constexpr double g_m_s2 = 9.80665;

inline DormancyPlan until(DormantUntil what, float height_m = 500.0F) {
  DormancyPlan plan = default_plan().dormancy;
  plan.until = what;
  plan.height_m = height_m;
  plan.burn_time = ms(1'000);
  return plan;
}

/// A gate and what it is shown, at 1 kHz; first thrust is at zero.
class GatedAscent {
 public:
  explicit GatedAscent(const DormancyPlan& plan) : gate{plan} {
    motion.gyro = motion.accelerometer = SensorState::fresh;
    motion.speed_m_s = 50.0F;
  }

  bool tick() {
    now += ms(1);
    gate.update(now, motion);
    return gate.is_open();
  }
  bool reads(double axial_g, Microseconds length) {
    motion.specific_force_m_s2.x = static_cast<float>(axial_g * g_m_s2);
    for (const Microseconds end = now + length; now < end;) {
      tick();
    }
    return gate.is_open();
  }
  /// From now on, reading this: after how long the gate is another one, in seconds.
  double changes_after(double axial_g) {
    const bool before = gate.is_open();
    const Microseconds begin = now;
    while (gate.is_open() == before && now - begin < ms(120'000)) {
      reads(axial_g, ms(1));
    }
    return static_cast<double>((now - begin).count()) * 1e-6;
  }
  bool flies_at(double speed_m_s, double height_m = 0.0) {
    motion.speed_squared_m2_s2 = static_cast<float>(speed_m_s * speed_m_s);
    motion.height_m = static_cast<float>(height_m);
    return tick();
  }

  DormancyGate gate;
  Motion motion;
  Microseconds now{};
};

}  // namespace fantail::core
