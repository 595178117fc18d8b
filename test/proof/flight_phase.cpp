// SPDX-License-Identifier: MIT
// From any state of the flight phase, with any plan, any inputs and any motion, one tick makes only the transitions
// that the table of phases in docs/architecture.md has. Because this holds from any state, it holds in every run:
//   - Safe is left for Armed alone, and only with the arm switch closed and the arm command in the same tick;
//   - an armed rocket whose switch is open is Safe;
//   - Controlling is entered from Launched of a launch plan, or by the start command of a tunnel plan at rest; so there
//   is
//     no way from Safe to Controlling without switch and command, and no command starts a launch plan;
//   - from Launched only beyond the guide, fast enough, and while the accelerometers agree;
//   - Launched is entered from Armed, by a detection that was listened for;
//   - Finished is final, and Controlling is left for Finished alone.
#include "core/flight_phase.cpp"

#include "proof.hpp"

using namespace fantail;
using namespace fantail::core;
using namespace fantail::proof;

int main() {
  const RunPlan run{.start = any_of<Start>(2),
                    .control_time = any_time(),
                    .tilt_limit = any_angle(),
                    .canard_fault = any_of<CanardFaultPolicy>(3),
                    .overrun_limit = nondet_u16()};
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
                           .canard_fault = nondet_bool()};
  Motion motion{};
  motion.distance_along_guide_m = nondet_float();
  motion.speed_m_s = nondet_float();
  motion.vertical_speed_m_s = nondet_float();
  motion.tilt = any_angle();
  motion.gyro = any_of<SensorState>(4);
  motion.speed_is_lower_bound = nondet_bool();
  motion.at_rest_for = any_time();

  const Phase from = phase.phase();
  const bool listened = phase.listens_for_launch() || motion.at_rest_for >= motion_plan.rest_time;
  const bool changed = phase.update(inputs, motion);
  const Phase to = phase.phase();

  CLAIM(changed == (from != to));
  CLAIM(from != Phase::safe || to == Phase::safe || to == Phase::armed);
  CLAIM(!(from == Phase::safe && to == Phase::armed) || (inputs.arm_switch_closed && inputs.arm_command));
  CLAIM(from != Phase::armed || inputs.arm_switch_closed || to == Phase::safe);
  CLAIM(to != Phase::launched || from == Phase::launched ||
        (from == Phase::armed && inputs.launch_detected && listened));
  CLAIM(to != Phase::launched || from == Phase::launched || run.start == Start::launch);
  CLAIM(to != Phase::controlling || from == Phase::controlling || from == Phase::launched ||
        (from == Phase::armed && run.start == Start::tunnel && inputs.start_command && inputs.arm_switch_closed &&
         motion.at_rest_for >= motion_plan.rest_time));
  CLAIM(!(from == Phase::launched && to == Phase::controlling) ||
        (motion.distance_along_guide_m >= guide.length_m + guide.clearance_m &&
         motion.speed_m_s > guide.minimum_speed_m_s && inputs.accelerometers_agree && !inputs.timing_fault));
  CLAIM(from != Phase::launched || to == Phase::launched || to == Phase::controlling || to == Phase::armed);
  CLAIM(from != Phase::controlling || to == Phase::controlling || to == Phase::finished);
  CLAIM(from != Phase::finished || to == Phase::finished);
  CLAIM(to != Phase::finished || from == Phase::finished || from == Phase::controlling);
  CLAIM(!(to == Phase::controlling && changed) || phase.control_start() == inputs.time);

  REACHABLE(1, from == Phase::safe && to == Phase::armed);
  REACHABLE(2, from == Phase::launched && to == Phase::controlling);
  REACHABLE(3, from == Phase::armed && to == Phase::controlling);
  REACHABLE(4, from == Phase::controlling && to == Phase::finished);
  return 0;
}
