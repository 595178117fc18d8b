// SPDX-License-Identifier: MIT
#pragma once

#include "core/autopilot.hpp"
#include "core/flight_plan_fields.hpp"
#include "milliseconds.hpp"
#include "motion_rig.hpp"
#include "test.hpp"
#include "tunnel_run.hpp"

namespace fantail::core {

/// An autopilot on a rig, at 1 kHz, with canards that stand where they are told.
class Rocket {
 public:
  explicit Rocket(const FlightPlan& plan) : autopilot_{plan} {
    inputs_changed_by([](Inputs&) {});
  }

  /// What the hardware does to every tick from now on.
  void inputs_changed_by(std::function<void(Inputs&)> change) { change_ = std::move(change); }

  const TickRecord& tick(double acceleration_m_s2 = 0.0, double roll_rate_rad_s = 0.0) {
    return step(ms(1), acceleration_m_s2, roll_rate_rad_s, false);
  }
  /// The first tick after a reset, in flight, that took so long.
  const TickRecord& resume(Microseconds gap, double acceleration_m_s2 = 0.0, double roll_rate_rad_s = 0.0) {
    return step(gap, acceleration_m_s2, roll_rate_rad_s, true);
  }
  const TickRecord& run(Microseconds length, double acceleration_m_s2 = 0.0, double roll_rate_rad_s = 0.0) {
    for (const Microseconds end = rig.time() + length; rig.time() < end;) {
      tick(acceleration_m_s2, roll_rate_rad_s);
    }
    return record_;
  }
  /// Until the phase is another one; how long that took.
  Microseconds run_until_phase_changes(double acceleration_m_s2 = 0.0, double roll_rate_rad_s = 0.0) {
    const Phase before = record_.phase;
    const Microseconds begin = rig.time();
    while (record_.phase == before && rig.time() - begin < ms(60'000)) {
      tick(acceleration_m_s2, roll_rate_rad_s);
    }
    return rig.time() - begin;
  }
  void command_once(const std::function<void(Inputs&)>& command) {
    const auto always = change_;
    change_ = [&](Inputs& inputs) {
      always(inputs);
      command(inputs);
    };
    tick();
    change_ = always;
  }
  void arm() {
    command_once([](Inputs& inputs) { inputs.arm_command = true; });
  }
  void arm_on_pad() {
    run(ms(4'000));
    arm();
    run(ms(200));
    expect(Phase::armed, PhaseReason::armed_by_switch_and_command);
  }
  void fly_to_control(double roll_rate_rad_s = 0.0) {
    arm_on_pad();
    run_until_phase_changes(40.0, roll_rate_rad_s);
    run_until_phase_changes(40.0, roll_rate_rad_s);
    expect(Phase::controlling, PhaseReason::guide_clear);
  }
  void expect(Phase phase, PhaseReason reason) const {
    EXPECT_EQ(name(record_.phase), name(phase));
    EXPECT_EQ(name(record_.reason), name(reason));
  }
  [[nodiscard]] const TickRecord& record() const { return record_; }

  MotionRig rig;

 private:
  const TickRecord& step(Microseconds time, double acceleration_m_s2, double roll_rate_rad_s, bool resumes) {
    rig.advance(time, acceleration_m_s2, roll_rate_rad_s);
    Inputs inputs = rig.inputs();
    inputs.arm_switch_closed = true;
    for (std::size_t i = 0; i < canard_count; ++i) {
      inputs.encoders[i] = record_.canards[i].angle;
    }
    change_(inputs);
    if (resumes) {
      autopilot_.resume(inputs);
    }
    record_ = autopilot_.step(inputs);
    EXPECT_TRUE(record_.phase == Phase::controlling || record_.command == Angle{});
    return record_;
  }

  Autopilot autopilot_;
  std::function<void(Inputs&)> change_;
  TickRecord record_;
};

}  // namespace fantail::core
