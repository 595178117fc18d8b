// SPDX-License-Identifier: MIT
#include "core/flight_phase.hpp"

namespace fantail::core {
namespace {

// Guides stand within this of the vertical. What has landed lies on its side or hangs on its nose.
constexpr Angle steepest_guide = Angle::from_degrees(45.0F);

// Longer than any rocket climbs that this law was made for. Where the speed is only a lower bound nobody sees apogee.
constexpr Microseconds longest_dormancy{120'000'000};

// Meets BAR-1.
bool falls(const PhaseInputs& inputs, const Motion& motion) {
  return motion.vertical_speed_m_s < 0.0F && !motion.speed_is_lower_bound && !inputs.climbs;
}

}  // namespace

FlightPhase::FlightPhase(const RunPlan& run, const GuidePlan& guide, const MotionPlan& motion)
    : run_{run}, guide_{guide}, motion_{motion} {}

bool FlightPhase::listens_for_launch() const {
  return phase_ == Phase::armed && run_.start == Start::launch && !must_rest_first_;
}

bool FlightPhase::update(const PhaseInputs& inputs, const Motion& motion) {
  watch_rest(motion);
  std::optional<Transition> next;
  switch (phase_) {
    case Phase::safe: next = from_safe(inputs); break;
    case Phase::armed: next = from_armed(inputs, motion); break;
    case Phase::launched: next = from_launched(inputs, motion); break;
    case Phase::dormant: next = from_dormant(inputs, motion); break;
    case Phase::controlling: next = from_controlling(inputs, motion); break;
    case Phase::finished: break;  // lasts until a power cycle
  }
  if (!next) {
    return false;
  }
  // Whatever looked like a launch was none: a rocket that is being handled must first stand still. Only rest ends
  // this; disarming and arming again does not.
  // Meets PHS-2.
  must_rest_first_ = must_rest_first_ || (phase_ == Phase::launched && next->to == Phase::armed);
  if (next->to == Phase::controlling) {
    control_start_ = control_start_.value_or(inputs.time);
  }
  phase_ = next->to;
  reason_ = next->reason;
  entered_ = inputs.time;
  return true;
}

// Meets PHS-5.
void FlightPhase::watch_rest(const Motion& motion) {
  const bool waits = phase_ == Phase::armed && run_.start == Start::launch;
  must_rest_first_ = must_rest_first_ || (waits && motion.has_moved);
  if (motion.at_rest_for >= motion_.rest_time && !motion.has_moved && motion.tilt <= steepest_guide) {
    must_rest_first_ = false;
  }
  if (waits && must_rest_first_ != waits_for_rest(reason_)) {
    reason_ = must_rest_first_ ? PhaseReason::moved_without_launch : PhaseReason::rested;
  }
}

void FlightPhase::give_up(Microseconds time) {
  if (is_flight(phase_)) {
    phase_ = Phase::finished;
    reason_ = PhaseReason::memory_fault;
    entered_ = time;
  }
}

std::optional<FlightPhase::Transition> FlightPhase::from_safe(const PhaseInputs& inputs) const {
  // Meets ARM-1.
  // Two independent actions: a switch that a hand closes, and a command. Neither alone arms.
  if (inputs.arm_switch_closed && inputs.arm_command && !inputs.abort) {
    return Transition{Phase::armed, PhaseReason::armed_by_switch_and_command};
  }
  return std::nullopt;
}

std::optional<FlightPhase::Transition> FlightPhase::from_armed(const PhaseInputs& inputs, const Motion& motion) const {
  // Meets ARM-2.
  // The switch is the pad crew's way out. It is obeyed here and in no later phase: a switch that opens under
  // vibration must not end a flight.
  if (!inputs.arm_switch_closed) {
    return Transition{Phase::safe, PhaseReason::disarmed_by_switch};
  }
  // Meets ABT-1.
  if (inputs.abort) {
    return Transition{Phase::safe, PhaseReason::aborted};
  }
  // Meets PHS-5.
  // The parachute opens, the rocket lands and is picked up: nothing of this may be taken for a launch.
  if (run_.start == Start::launch && motion.has_fallen) {
    return Transition{Phase::finished, PhaseReason::flew_without_launch};
  }
  // Meets PHS-3.
  // In the tunnel nothing accelerates: control begins on command, and only from rest, when the roll angle means
  // something and nobody holds a turning rocket. A late tick has not watched the rest.
  const bool at_rest = motion.at_rest_for >= motion_.rest_time && !inputs.timing_fault;
  if (run_.start == Start::tunnel && inputs.start_command && at_rest) {
    return Transition{Phase::controlling, PhaseReason::tunnel_start_command};
  }
  // The hold of the launch detector keeps knocks and sensor errors out; what it lets through, the guide clearance
  // below still has to confirm.
  if (listens_for_launch() && inputs.launch_detected) {
    return Transition{Phase::launched, PhaseReason::launch_detected};
  }
  return std::nullopt;
}

std::optional<FlightPhase::Transition> FlightPhase::from_launched(const PhaseInputs& inputs,
                                                                  const Motion& motion) const {
  if (inputs.abort) {
    return Transition{Phase::finished, PhaseReason::aborted};
  }
  // Without a rate there is no roll angle, and with a broken clock no height: such a flight is never controlled.
  if (inputs.timing_fault) {
    return Transition{Phase::armed, PhaseReason::timing_fault_before_control};
  }
  if (motion.gyro == SensorState::failed) {
    return Transition{Phase::armed, PhaseReason::gyro_failed_before_control};
  }
  // Meets PHS-2.
  // Canards that move inside the guide can jam the rocket in it. Both figures must say that it has left: a knock
  // gives speed without distance, a drifting accelerometer distance without speed. Lower bounds serve as well: what is
  // at least beyond the guide is beyond it; with a range of 16 g they say so of a guide of 6 m after 0.3 s.
  const bool beyond_guide = motion.distance_along_guide_m >= guide_.length_m + guide_.clearance_m;
  // Meets DET-4.
  // Both figures come from one accelerometer. When another one disagrees, it may be stuck in a rocket that is shaken.
  const bool clear = beyond_guide && motion.speed_m_s > guide_.minimum_speed_m_s && inputs.accelerometers_agree;
  // A gyro that is silent is waited for: control never begins with a rate that nobody measures.
  if (clear && motion.gyro != SensorState::lost) {
    return Transition{inputs.gate_is_open ? Phase::controlling : Phase::dormant, PhaseReason::guide_clear};
  }
  // A real launch is clear of the guide within about half a second; what takes this long was something else.
  if (inputs.time - entered_ >= guide_.clearance_time) {
    return Transition{Phase::armed, PhaseReason::guide_not_cleared_in_time};
  }
  return std::nullopt;
}

// What ends every flight that has left the guide.
std::optional<PhaseReason> FlightPhase::fault_in_flight(const PhaseInputs& inputs, const Motion& motion) const {
  // Meets ABT-1.
  if (inputs.abort) {
    return PhaseReason::aborted;
  }
  // A tick that came late or twice makes every rate and angle doubtful.
  if (inputs.timing_fault) {
    return PhaseReason::timing_fault;
  }
  // Meets SEN-1.
  // Without a rate the canards are at trim; for how long that can be bridged is in the plan.
  if (motion.gyro == SensorState::failed) {
    return PhaseReason::gyro_failed;
  }
  // Three canards still control roll, so by default a fault is recorded, and the others do its part too.
  if (inputs.canard_fault && run_.canard_fault == CanardFaultPolicy::end_control) {
    return PhaseReason::canard_fault;
  }
  // Canards deflected on a rocket that lies across the wind steer it: past this tilt they can only do harm.
  if (run_.start == Start::launch && motion.tilt_from_guide.value_or(motion.tilt) > run_.tilt_limit) {
    return PhaseReason::tilted_too_far;
  }
  return std::nullopt;
}

// Meets PHS-4.
// What ends control that has begun, also while the gate is closed again.
std::optional<PhaseReason> FlightPhase::end_of_control(const PhaseInputs& inputs, const Motion& motion) const {
  // Near apogee there is no flow over the canards, and after it the recovery system works.
  // A speed that is a lower bound comes to zero too early: then time and tilt end control.
  if (run_.start == Start::launch && falls(inputs, motion)) {
    return PhaseReason::apogee;
  }
  if (inputs.time - control_start_.value_or(entered_) >= run_.control_time) {
    return PhaseReason::control_time_over;
  }
  return std::nullopt;
}

// Meets DOR-1.
std::optional<FlightPhase::Transition> FlightPhase::from_dormant(const PhaseInputs& inputs,
                                                                 const Motion& motion) const {
  std::optional<PhaseReason> end = fault_in_flight(inputs, motion);
  if (!end && control_start_) {
    end = end_of_control(inputs, motion);
  } else if (!end && (falls(inputs, motion) || inputs.time - entered_ >= longest_dormancy)) {
    // Time opens no gate: what the plan waits for has not come in this flight, and the canards have stood at trim.
    end = PhaseReason::gate_never_opened;
  }
  if (end) {
    return Transition{Phase::finished, *end};
  }
  if (inputs.gate_is_open && motion.gyro != SensorState::lost) {
    return Transition{Phase::controlling, PhaseReason::gate_open};
  }
  return std::nullopt;
}

std::optional<FlightPhase::Transition> FlightPhase::from_controlling(const PhaseInputs& inputs,
                                                                     const Motion& motion) const {
  if (const auto fault = fault_in_flight(inputs, motion)) {
    return Transition{Phase::finished, *fault};
  }
  if (const auto end = end_of_control(inputs, motion)) {
    return Transition{Phase::finished, *end};
  }
  if (!inputs.gate_is_open) {
    return Transition{Phase::dormant, PhaseReason::gate_closed_again};
  }
  return std::nullopt;
}

}  // namespace fantail::core
