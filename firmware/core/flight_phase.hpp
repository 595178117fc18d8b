// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/flight_plan.hpp"
#include "core/motion_estimator.hpp"

namespace fantail::core {

enum class Phase : std::uint8_t {
  safe,         ///< power-on state, always
  armed,        ///< after two independent actions; waits for a launch
  launched,     ///< launch detected; the guide is not yet clear
  controlling,  ///< the only phase in which the roll command is not zero
  finished,     ///< until a power cycle
};
inline constexpr std::size_t phases = 5;

/// Why the phase is what it is: the reason of the last transition.
enum class PhaseReason : std::uint8_t {
  power_on,
  armed_by_switch_and_command,
  disarmed_by_switch,
  launch_detected,
  guide_clear,
  tunnel_start_command,
  guide_not_cleared_in_time,
  gyro_failed_before_control,
  timing_fault_before_control,
  control_time_over,
  apogee,
  tilted_too_far,
  gyro_failed,
  timing_fault,
  canard_fault,
  memory_fault,
};
inline constexpr std::size_t phase_reasons = 16;

/// What one tick may move the phase, besides the motion.
struct PhaseInputs {
  Microseconds time{};
  bool arm_switch_closed = false;
  bool arm_command = false;
  bool start_command = false;
  bool launch_detected = false;
  bool accelerometers_agree = true;  ///< in Launched; without it control does not begin
  bool timing_fault = false;
  bool canard_fault = false;
};

/// Safe -> Armed -> Launched -> Controlling -> Finished. Starts in Safe; there is no way to set a phase, but to give
/// up.
class FlightPhase {
 public:
  FlightPhase(const RunPlan& run, const GuidePlan& guide, const MotionPlan& motion);

  /// True when this tick changed the phase.
  bool update(const PhaseInputs& inputs, const Motion& motion);

  /// The memory of the law is not what it was: a flight is over, as far as control goes.
  [[gnu::cold]] void give_up(Microseconds time);

  [[nodiscard]] Phase phase() const { return phase_; }
  [[nodiscard]] PhaseReason reason() const { return reason_; }

  /// May a launch be detected now? After a detection that was none, only when the rocket has been at rest again.
  [[nodiscard]] bool listens_for_launch() const;

  /// Empty until control has started.
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

  [[nodiscard]] std::optional<Transition> from_safe(const PhaseInputs& inputs) const;
  [[nodiscard]] std::optional<Transition> from_armed(const PhaseInputs& inputs, const Motion& motion) const;
  [[nodiscard]] std::optional<Transition> from_launched(const PhaseInputs& inputs, const Motion& motion) const;
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
