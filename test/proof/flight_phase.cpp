// SPDX-License-Identifier: MIT
// From any state of the flight phase, with any plan, any inputs and any motion, one tick makes only the transitions
// that the table of phases in docs/architecture.md has. Because this holds from any state, it holds in every run:
//   - Safe is left for Armed alone, and only with the arm switch closed and the arm command in the same tick;
//   - an armed rocket whose switch is open is Safe;
//   - Controlling is entered from Launched or Dormant of a launch plan while the gate is open, or by the start command
//     of a tunnel plan at rest; so there is no way from Safe to Controlling without switch and command, and no command
//     starts a launch plan;
//   - from Launched, and so to Dormant, only beyond the guide, fast enough, while the accelerometers agree and the gyro
//     is not silent; from Dormant only while it is not;
//   - behind a closed gate nothing is Controlling, but in the tick in which a tunnel starts;
//   - in a tick with an abort the rocket is Safe or Finished afterwards;
//   - Launched is entered from Armed, by a detection that was listened for;
//   - a rocket that has moved without a launch, or that has come back from Launched, listens for none: in no later tick
//     either, before it has rested for the plan's time, near the vertical, and since it last moved;
//   - an armed rocket that has fallen is Finished, unless its switch is open;
//   - Finished is final, and Controlling is left for Finished, or for Dormant where the gate has closed.
#include "core/flight_phase.cpp"

#include "proof.hpp"

using namespace fantail;
using namespace fantail::core;
using namespace fantail::proof;

int main() {
  const RunPlan run{.start = any_of<Start>(2),
                    .control_time = any_time(),
                    .tilt_limit = any_angle(),
                    .tilt_from = any_of<TiltOrigin>(2),
                    .canard_fault = any_of<CanardFaultPolicy>(3),
                    .overrun_limit = nondet_u16(),
                    .abort_input = any_of<AbortInput>(3)};
  const GuidePlan guide{.length_m = nondet_float(),
                        .clearance_m = nondet_float(),
                        .minimum_speed_m_s = nondet_float(),
                        .clearance_time = any_time()};
  MotionPlan motion_plan{};
  motion_plan.rest_time = any_time();
  FlightPhase phase{run, guide, motion_plan};
  Anything anything;
  phase.visit_state(anything);

  const PhaseInputs inputs{.time = any_time(),
                           .arm_switch_closed = nondet_bool(),
                           .arm_command = nondet_bool(),
                           .start_command = nondet_bool(),
                           .launch_detected = nondet_bool(),
                           .accelerometers_agree = nondet_bool(),
                           .timing_fault = nondet_bool(),
                           .canard_fault = nondet_bool(),
                           .gate_is_open = nondet_bool(),
                           .abort = nondet_bool(),
                           .climbs = nondet_bool()};
  Motion motion{};
  motion.distance_along_guide_m = nondet_float();
  motion.speed_m_s = nondet_float();
  motion.vertical_speed_m_s = nondet_float();
  motion.tilt = any_angle();
  motion.tilt_from_guide = any_optional_angle();
  motion.gyro = any_of<SensorState>(4);
  motion.speed_is_lower_bound = nondet_bool();
  motion.at_rest_for = any_time();
  motion.has_moved = nondet_bool();
  motion.has_fallen = nondet_bool();

  const Phase from = phase.phase();
  const bool launches = run.start == Start::launch;
  const bool rested = motion.at_rest_for >= motion_plan.rest_time && !motion.has_moved;
  const auto control_start = phase.control_start();
  const bool clear = motion.distance_along_guide_m >= guide.length_m + guide.clearance_m &&
                     motion.speed_m_s > guide.minimum_speed_m_s && inputs.accelerometers_agree;
  const bool measures = motion.gyro != SensorState::lost && motion.gyro != SensorState::failed;
  const bool listened_before = phase.listens_for_launch();
  const bool listened = (listened_before && !motion.has_moved) || rested;
  const bool changed = phase.update(inputs, motion);
  const Phase to = phase.phase();

  CLAIM(changed == (from != to));
  CLAIM(from != Phase::safe || to == Phase::safe || to == Phase::armed);
  CLAIM(!(from == Phase::safe && to == Phase::armed) || (inputs.arm_switch_closed && inputs.arm_command));
  CLAIM(from != Phase::armed || inputs.arm_switch_closed || to == Phase::safe);
  CLAIM(to != Phase::launched || from == Phase::launched ||
        (from == Phase::armed && inputs.launch_detected && listened));
  CLAIM(to != Phase::launched || from == Phase::launched || run.start == Start::launch);
  CLAIM(to != Phase::controlling || from == Phase::controlling || from == Phase::launched || from == Phase::dormant ||
        (from == Phase::armed && run.start == Start::tunnel && inputs.start_command && inputs.arm_switch_closed &&
         motion.at_rest_for >= motion_plan.rest_time));
  CLAIM(!(from == Phase::launched && (to == Phase::controlling || to == Phase::dormant)) ||
        (clear && !inputs.timing_fault && measures));
  CLAIM(!(from == Phase::dormant && to == Phase::controlling) || (!inputs.timing_fault && measures));
  CLAIM(to != Phase::controlling || from == Phase::armed || inputs.gate_is_open);
  CLAIM(to != Phase::dormant || from == Phase::dormant || !inputs.gate_is_open);
  CLAIM(to != Phase::dormant || from == Phase::dormant || from == Phase::launched || from == Phase::controlling);
  CLAIM(!inputs.abort || to == Phase::safe || to == Phase::finished);
  CLAIM(from != Phase::launched || to == Phase::launched || to == Phase::controlling || to == Phase::dormant ||
        to == Phase::armed || (to == Phase::finished && inputs.abort));
  CLAIM(from != Phase::dormant || to == Phase::dormant || to == Phase::controlling || to == Phase::finished);
  CLAIM(from != Phase::controlling || to == Phase::controlling || to == Phase::finished || to == Phase::dormant);
  CLAIM(from != Phase::finished || to == Phase::finished);
  CLAIM(to != Phase::finished || from == Phase::finished || from == Phase::controlling || from == Phase::dormant ||
        (from == Phase::launched && inputs.abort) || (from == Phase::armed && launches && motion.has_fallen));
  CLAIM(!(from == Phase::armed && launches && motion.has_fallen) || to == Phase::finished || to == Phase::safe);
  CLAIM(!(from == Phase::armed && motion.has_moved) || !phase.listens_for_launch());
  CLAIM(!(from == Phase::armed && !listened_before && !rested) || !phase.listens_for_launch());
  CLAIM(!(from == Phase::launched && to == Phase::armed) || !phase.listens_for_launch());
  CLAIM(!(to == Phase::controlling && changed) || phase.control_start() == control_start.value_or(inputs.time));

  REACHABLE(1, from == Phase::safe && to == Phase::armed);
  REACHABLE(2, from == Phase::launched && to == Phase::controlling);
  REACHABLE(3, from == Phase::armed && to == Phase::controlling);
  REACHABLE(4, from == Phase::controlling && to == Phase::finished);
  REACHABLE(5, from == Phase::armed && to == Phase::finished);
  REACHABLE(6, from == Phase::armed && !listened_before && phase.listens_for_launch());
  REACHABLE(7, from == Phase::launched && to == Phase::dormant);
  REACHABLE(8, from == Phase::dormant && to == Phase::controlling);
  REACHABLE(9, from == Phase::controlling && to == Phase::dormant);
  return 0;
}
