// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "core/canard_mixer.hpp"
#include "core/canard_monitor.hpp"
#include "core/canard_sharing.hpp"
#include "core/capture.hpp"
#include "core/chirp.hpp"
#include "core/dormancy_gate.hpp"
#include "core/flight_phase.hpp"
#include "core/flight_plan.hpp"
#include "core/gain_schedule.hpp"
#include "core/inputs.hpp"
#include "core/launch_detector.hpp"
#include "core/motion_estimator.hpp"
#include "core/offset_estimator.hpp"
#include "core/tick_record.hpp"

namespace fantail::core {

/// The flight law. Time and samples come in, canard commands and a record go out; there is no clock, no heap and no
/// input or output in it, so the same object flies in the rocket, in the simulator and in a replay.
///
///   motion_estimator, barometric_height -> launch_detector, dormancy_gate -> flight_phase -> roll_reference + capture
///   + chirp
///     -> pd_controller, with gain_schedule and offset_estimator where the plan asks for them (clamp)
///     -> canard_sharing, while a canard does not follow -> canard_mixer (clamp each);  canard_monitor watches;  the
///     record holds all of it
class Autopilot {
 public:
  /// `plan` has passed validate().
  [[gnu::cold]] explicit Autopilot(const FlightPlan& plan);

  /// One tick, nominally every millisecond. The commands for the servos are `canards` in the record, which stays valid
  /// until the next step.
  const TickRecord& step(const Inputs& inputs);

  /// The state has come back after a reset, in flight, and `first` is what the next step() is given: bridges what
  /// nobody saw, which is no timing fault. The clock has gone on, so reference, excitation and every limit of time have
  /// too.
  void resume(const Inputs& first);

  /// Safe in a new object; then as step(), give_up() or a state that was put back left it.
  [[nodiscard]] Phase phase() const { return flight_phase_.phase(); }

  /// The memory of the law is not what it was: a flight is over, as far as control goes.
  void give_up(Microseconds time) { flight_phase_.give_up(time); }

  /// All of this object that decides about a command in flight, but for the launch detector, which in flight can only
  /// put off the beginning of control. Nothing but step() changes any of it.
  [[nodiscard]] std::span<const std::byte> flight_memory() const;

  /// Is this canard still moved by what the plan, of which this was made, says?
  [[nodiscard]] bool moves_as_planned(std::size_t canard, const FlightPlan& plan) const {
    return canard_mixer_.moves_as_planned(canard, plan.canards, plan.controller.canard_limit);
  }

  /// Largest shaft angle that can ever be commanded to this canard.
  [[nodiscard]] Angle canard_limit(std::size_t canard) const { return canard_mixer_.limit(canard); }

  /// See core/state_visitor.hpp. The record is no state: it is made anew in every step.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(motion_estimator_, launch_detector_, flight_phase_, chirp_, offset_estimator_, canard_mixer_, canard_monitor_,
          canard_sharing_, last_time_, canard_fault_, overruns_, overruns_before_flight_);
    if (is_gated_) {  // as the plan says: a law without a gate has no memory of one
      visit(dormancy_gate_);
    }
    if (captures_) {
      visit(capture_, turns_);
    }
    if (has_barometer_) {
      visit(barometric_height_);
    }
  }

 private:
  /// Counts the ticks that did not come; true when this one came at a time that makes it doubtful.
  [[nodiscard]] bool watch_clock(Microseconds time);
  void enter_phase(Microseconds time, Phase from, Phase to);
  void begin_control(const Motion& motion, Microseconds time);
  void watch_height(const Inputs& inputs, Phase before, bool agree);
  /// The roll command that each canard is asked for.
  [[nodiscard]] Angle control(Microseconds since_control_start);
  /// Whether the work of a canard that does not follow goes to the others.
  [[nodiscard]] bool shares_work();
  [[nodiscard]] [[gnu::always_inline]] inline RollCommand adapted_command();
  void stay_neutral(CommandStatus why);

  TickRecord record_;

  // From here on flight_memory() where the plan has a barometer, from the gate on where it waits for one or captures,
  // and else from the law on.
  BarometricHeight barometric_height_;
  DormancyGate dormancy_gate_;
  Capture capture_;
  ControllerPlan controller_;
  GainSchedule gain_schedule_;
  bool adapts_;  ///< by a schedule, or to an offset
  ReferencePlan reference_;
  std::uint32_t overrun_limit_;
  FlightPhase flight_phase_;
  bool is_gated_;
  bool captures_;
  bool has_barometer_;
  Angle turns_;  ///< of capture, on the reference
  Chirp chirp_;
  OffsetEstimator offset_estimator_;
  CanardMixer canard_mixer_;
  bool shares_;
  CanardSharing canard_sharing_;
  std::optional<Microseconds> last_time_;
  bool canard_fault_ = false;
  std::uint32_t overruns_ = 0;                ///< since the first tick
  std::uint32_t overruns_before_flight_ = 0;  ///< of these, up to launch detection or the tunnel's start
  MotionEstimator motion_estimator_;          // late, because it is large

  LaunchDetector launch_detector_;
  CanardMonitor canard_monitor_;
};

}  // namespace fantail::core
