// SPDX-License-Identifier: MIT
// From any state, with any plan, any inputs and any answers of its parts (any_parts.hpp), one step of the flight law:
//   - asks the mixer once;
//   - hands it the request of bench or self-test only when the phase after this step is Safe;
//   - asks for a roll command of exactly zero in every phase but Controlling, and in Controlling while the gyro is lost
//     and nothing is shared;
//   - has in the record a command within the plan limit, and zero outside Controlling; without sharing, the mixer is
//   asked
//     for that very command;
//   - asks for a roll command of exactly zero while the plan's gate is closed, with a plan that validate() lets fly:
//   one
//     for the tunnel waits for the guide alone;
//   - changes the phase only as FlightPhase does: not from Safe to Controlling, not out of Finished.
// With canard_mixer.cpp, which holds for any roll command and any request, this makes the whole step: no command beyond
// a limit in any phase, and trim, by the first motion's way, wherever the roll command is zero and nothing is
// requested.
#include "core/autopilot.cpp"

#include "any_parts.hpp"
#include "core/flight_phase.cpp"

using namespace fantail;
using namespace fantail::core;
using namespace fantail::proof;

int main() {
  FlightPlan plan{};
  plan.run = {.start = any_of<Start>(2),
              .control_time = any_instant(),
              .tilt_limit = any_angle(),
              .tilt_from = any_of<TiltOrigin>(2),
              .canard_fault = any_of<CanardFaultPolicy>(3),
              .overrun_limit = nondet_u16(),
              .abort_input = any_of<AbortInput>(3)};
  plan.guide = {.length_m = nondet_float(),
                .clearance_m = nondet_float(),
                .minimum_speed_m_s = nondet_float(),
                .clearance_time = any_instant()};
  plan.motion.rest_time = any_instant();
  plan.dormancy.until = any_of<DormantUntil>(6);
  plan.sensors.barometer = any_of<BarometerUse>(2);
  assume(plan.run.start == Start::launch || plan.dormancy.until == DormantUntil::guide);
  plan.offset.rejection = any_of<OffsetRejection>(3);
  plan.controller = {.proportional_gain = nondet_float(),
                     .derivative_gain_s = nondet_float(),
                     .rate_reference = any_of<RateReference>(2),
                     .canard_limit = any_angle(),
                     .entry = any_of<ControlEntry>(2)};
  assume(plan.controller.canard_limit >= Angle{} && plan.controller.canard_limit <= hard_canard_limit);

  gate_is_open = plan.dormancy.until == DormantUntil::guide || nondet_bool();

  Autopilot autopilot{plan};
  Anything anything;
  anything(autopilot.flight_phase_, autopilot.last_time_, autopilot.canard_fault_, autopilot.overruns_,
           autopilot.overruns_before_flight_);

  Inputs inputs{};
  inputs.time = any_instant();
  inputs.arm_switch_closed = nondet_bool();
  inputs.arm_command = nondet_bool();
  inputs.start_command = nondet_bool();
  inputs.abort = nondet_bool();
  if (nondet_bool()) {
    inputs.canard_request = std::array<Angle, canard_count>{any_angle(), any_angle(), any_angle(), any_angle()};
  }

  const Phase before = autopilot.phase();
  const TickRecord& record = autopilot.step(inputs);
  const bool controls = record.phase == Phase::controlling;
  const bool shares = plan.run.canard_fault == CanardFaultPolicy::share;

  CLAIM(asked.calls == 1);
  CLAIM(record.phase == autopilot.phase());
  CLAIM(!asked.requested || record.phase == Phase::safe);
  CLAIM(controls || asked.roll_command == Angle{});
  CLAIM(controls || record.command == Angle{});
  CLAIM(gate_is_open || asked.roll_command == Angle{});
  CLAIM(!inputs.abort || asked.roll_command == Angle{});
  CLAIM(abs(record.command) <= plan.controller.canard_limit);
  CLAIM(shares || asked.roll_command == record.command);
  CLAIM(!controls || record.motion.gyro != SensorState::lost || record.command == Angle{});
  CLAIM(before != Phase::safe || record.phase == Phase::safe ||
        (record.phase == Phase::armed && inputs.arm_switch_closed && inputs.arm_command));
  CLAIM(before != Phase::finished || record.phase == Phase::finished);

  REACHABLE(1, asked.requested);
  REACHABLE(2, controls && !(asked.roll_command == Angle{}));
  REACHABLE(3, controls && before == Phase::launched);
  REACHABLE(4, controls && before == Phase::dormant && !(asked.roll_command == Angle{}));
  REACHABLE(5, record.phase == Phase::dormant && !gate_is_open);
  return 0;
}
