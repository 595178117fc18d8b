// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_phase.hpp"
#include "core/flight_plan_fields.hpp"
#include "milliseconds.hpp"
#include "test.hpp"
#include "tunnel_run.hpp"

namespace fantail::core {

struct Tick : PhaseInputs {
  Motion motion;
};

/// Drives the phases tick by tick; each test changes only what it is about.
class Sequence {
 public:
  explicit Sequence(const FlightPlan& plan = default_plan()) : plan_{plan}, phases_{plan.run, plan.guide, plan.motion} {
    next.arm_switch_closed = true;
    next.motion.gyro = SensorState::fresh;
  }

  bool tick() {
    next.time += ms(1);
    return phases_.update(next, next.motion);
  }
  /// One tick with something that lasts no longer.
  bool tick(const std::function<void(Tick&)>& change) {
    Tick once = next;
    once.time = next.time += ms(1);
    change(once);
    return phases_.update(once, once.motion);
  }
  Sequence& arm() {
    tick([](Tick& i) { i.arm_command = true; });
    return *this;
  }
  Sequence& launch() {
    tick([](Tick& i) { i.launch_detected = true; });
    return *this;
  }
  Sequence& clear_guide() {
    next.motion.distance_along_guide_m = 6.0F;
    next.motion.speed_m_s = 20.0F;
    next.motion.vertical_speed_m_s = 20.0F;
    tick();
    return *this;
  }
  Sequence& start_tunnel() {
    next.motion.at_rest_for = plan_.motion.rest_time;
    tick([](Tick& i) { i.start_command = true; });
    return *this;
  }
  void expect(Phase phase, PhaseReason reason) const {
    EXPECT_EQ(phases_.phase(), phase);
    EXPECT_EQ(phases_.reason(), reason);
  }
  [[nodiscard]] const FlightPhase& phases() const { return phases_; }

  Tick next;

 private:
  FlightPlan plan_;
  FlightPhase phases_;
};

}  // namespace fantail::core
