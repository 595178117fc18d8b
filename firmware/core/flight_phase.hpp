// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/flight_plan.hpp"
#include "core/motion_estimator.hpp"

namespace fantail::core {

/// Where a run stands; FlightPhase has the ways from one to the next.
enum class Phase : std::uint8_t {
  safe,         ///< power-on state, always
  armed,        ///< after two independent actions; waits for a launch
  launched,     ///< launch detected; the guide is not yet clear
  controlling,  ///< the only phase in which the roll command is not zero
  finished,     ///< until a power cycle
  dormant,      ///< between Launched and Controlling: beyond the guide, and the plan's gate is closed
};
/// How many values Phase has: one that is read must be below.
inline constexpr std::size_t phases = 6;

/// In the air, before control or under it: what a reset must not end, and what a log keeps every tick of.
[[nodiscard]] constexpr bool is_flight(Phase phase) {
  return phase == Phase::launched || phase == Phase::dormant || phase == Phase::controlling;
}

/// Why the phase is what it is: the reason of the last transition.
enum class PhaseReason : std::uint8_t {
  power_on,                     ///< Safe, and never armed
  armed_by_switch_and_command,  ///< Safe to Armed: a command came while the switch was closed
  disarmed_by_switch,           ///< Armed to Safe: the switch is open
  launch_detected,              ///< Armed to Launched
  guide_clear,                  ///< Launched to Controlling, or to Dormant: far enough beyond the guide and fast enough
  tunnel_start_command,         ///< Armed to Controlling, at rest in the tunnel
  guide_not_cleared_in_time,    ///< Launched to Armed: it was no launch, and only rest lets the next one be detected
  gyro_failed_before_control,   ///< Launched to Armed: this flight is not controlled
  timing_fault_before_control,  ///< Launched to Armed: this flight is not controlled
  control_time_over,            ///< Controlling to Finished
  apogee,                       ///< the same: the vertical speed is below zero, and no mere lower bound
  tilted_too_far,               ///< Dormant or Controlling to Finished, as the next three; never in the tunnel
  gyro_failed,                  ///< no usable rate for longer than the plan lets control wait
  timing_fault,                 ///< a tick came no later than the last or much too late, or too many did not come
  canard_fault,                 ///< with a plan that ends control for it
  memory_fault,                 ///< give_up(): Launched, Dormant or Controlling to Finished
  moved_without_launch,         ///< stays Armed, but only rest lets a launch be detected: see PadMovement
  rested,                       ///< stays Armed, and a launch can be detected again
  flew_without_launch,          ///< Armed to Finished: it was weightless for so long that it has flown undetected
  gate_open,                    ///< Dormant to Controlling: what the plan waits for has come
  gate_closed_again,            ///< Controlling to Dormant: the motor pushes again
  gate_never_opened,            ///< Dormant to Finished: apogee, or two minutes, came first
  aborted,                      ///< the abort input: Armed to Safe; Launched, Dormant or Controlling to Finished
};
/// How many values PhaseReason has: one that is read must be below.
inline constexpr std::size_t phase_reasons = 23;

/// Armed for one of these reasons, a rocket detects no launch before it has rested.
[[nodiscard]] constexpr bool waits_for_rest(PhaseReason reason) {
  using enum PhaseReason;
  return reason == moved_without_launch || reason == guide_not_cleared_in_time ||
         reason == gyro_failed_before_control || reason == timing_fault_before_control;
}

/// What one tick may move the phase, besides the motion.
struct PhaseInputs {
  Microseconds time{};               ///< of this tick
  bool arm_switch_closed = false;    ///< needed for arming; opened in Armed it disarms, and later it is not asked
  bool arm_command = false;          ///< in this tick; obeyed in Safe, with the switch closed
  bool start_command = false;        ///< in this tick; obeyed in Armed, for a tunnel, at rest
  bool launch_detected = false;      ///< obeyed while listens_for_launch()
  bool accelerometers_agree = true;  ///< in Launched; without it control does not begin
  bool timing_fault =
      false;  ///< the time of this tick is doubtful: Launched goes back to Armed, Controlling ends, no run begins
  bool canard_fault = false;  ///< some canard is not healthy; what follows from it says the plan
  bool gate_is_open = true;   ///< of DormancyGate
  bool abort = false;         ///< asked for at the abort input, by the plan's sense
  bool climbs = false;        ///< a barometer says so: apogee is then not believed of the accelerometer alone
};

/// Safe -> Armed -> Launched -> Dormant, while the plan's gate is closed -> Controlling -> Finished. Starts in Safe;
/// there is no way to set a phase, but to give up.
///
/// A launch is detected only by a rocket that has rested, near the vertical, since it last moved or took something for
/// a launch: a launch that was missed is followed by an opening parachute, a landing and people.
class FlightPhase {
 public:
  /// Three parts of one plan that has passed validate(); copied.
  FlightPhase(const RunPlan& run, const GuidePlan& guide, const MotionPlan& motion);

  /// True when this tick changed the phase. The reason of Armed may change without it.
  bool update(const PhaseInputs& inputs, const Motion& motion);

  /// The memory of the law is not what it was: a flight is over, as far as control goes.
  [[gnu::cold]] void give_up(Microseconds time);

  /// As the last update() or give_up() left it.
  [[nodiscard]] Phase phase() const { return phase_; }
  /// Of the last transition, however long ago, or of the last change within Armed.
  [[nodiscard]] PhaseReason reason() const { return reason_; }

  /// May a launch be detected now?
  [[nodiscard]] bool listens_for_launch() const;

  /// When control first started; empty before.
  [[nodiscard]] std::optional<Microseconds> control_start() const { return control_start_; }

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit.below(phases, phase_);
    visit.below(phase_reasons, reason_);
    visit(entered_, must_rest_first_, control_start_);
  }

 private:
  struct Transition {
    Phase to;
    PhaseReason reason;
  };

  void watch_rest(const Motion& motion);
  [[nodiscard]] [[gnu::always_inline]] inline std::optional<PhaseReason> fault_in_flight(const PhaseInputs& inputs,
                                                                                         const Motion& motion) const;
  [[nodiscard]] [[gnu::always_inline]] inline std::optional<PhaseReason> end_of_control(const PhaseInputs& inputs,
                                                                                        const Motion& motion) const;
  [[nodiscard]] std::optional<Transition> from_safe(const PhaseInputs& inputs) const;
  [[nodiscard]] std::optional<Transition> from_armed(const PhaseInputs& inputs, const Motion& motion) const;
  [[nodiscard]] std::optional<Transition> from_launched(const PhaseInputs& inputs, const Motion& motion) const;
  [[nodiscard]] std::optional<Transition> from_dormant(const PhaseInputs& inputs, const Motion& motion) const;
  [[nodiscard]] std::optional<Transition> from_controlling(const PhaseInputs& inputs, const Motion& motion) const;

  RunPlan run_;
  GuidePlan guide_;
  MotionPlan motion_;
  Phase phase_ = Phase::safe;
  PhaseReason reason_ = PhaseReason::power_on;
  Microseconds entered_{};
  bool must_rest_first_ = false;
  std::optional<Microseconds> control_start_;
};

}  // namespace fantail::core
