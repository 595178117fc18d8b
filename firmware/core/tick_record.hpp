// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/barometric_height.hpp"
#include "core/canard_mixer.hpp"
#include "core/canard_monitor.hpp"
#include "core/flight_phase.hpp"
#include "core/launch_detector.hpp"
#include "core/motion_estimator.hpp"

namespace fantail::core {

/// Why the roll command is what it is.
enum class CommandStatus : std::uint8_t {
  outside_control,  ///< exactly zero: not in Controlling
  controlling,      ///< what the law answers
  gyro_lost,        ///< zero for this tick: no usable rate
  not_finite,       ///< zero for this tick: the law gave no number
};
/// How many values CommandStatus has: one that is read must be below.
inline constexpr std::size_t command_statuses = 4;

/// Every signal of one tick. An output of Autopilot::step, so that the log, the telemetry and the simulator cannot
/// disagree about what happened.
struct TickRecord {
  Microseconds time{};  ///< Inputs::time of this step
  Phase phase = Phase::safe;
  PhaseReason reason = PhaseReason::power_on;
  DetectionState detection = DetectionState::quiet;
  CommandStatus command_status = CommandStatus::outside_control;
  bool timing_fault = false;   ///< not later than the last tick, more than 5 ms later, or too many overruns in flight
  std::uint32_t overruns = 0;  ///< ticks that were due and did not come, since the first one

  Motion motion{};
  std::optional<GyroVote> gyro_vote{};              ///< empty where the plan asks for one gyro
  std::optional<BarometerState> barometer_state{};  ///< empty where the plan asks for none

  /// R, with the turns of capture; zero outside of Controlling, as excitation and commands are.
  Angle reference{};
  Angle excitation{};         ///< what the chirp adds; also where no rate lets a command be given
  Angle offset_estimate{};    ///< of the fin offset: taken off the command, and in Dormant what capture will begin with
  Angle unclamped_command{};  ///< of the law, with the excitation
  Angle command{};            ///< what is made of it within the plan limit
  bool saturated = false;     ///< the canards together cannot give `unclamped_command`

  CanardCommands canards{};
  EncoderAngles encoders{};
  std::optional<Angle> canard_angle{};  ///< mean of the encoders
  CanardVerdicts verdicts{};
};

/// As files and pages have it; "unknown" for a number that is no value of the enumeration.
[[nodiscard]] std::string_view name(Phase phase);
[[nodiscard]] std::string_view name(PhaseReason reason);
[[nodiscard]] std::string_view name(CanardVerdict verdict);
[[nodiscard]] std::string_view name(SensorState state);
[[nodiscard]] std::string_view name(GyroVote vote);
[[nodiscard]] std::string_view name(BarometerState state);
[[nodiscard]] std::string_view name(CommandStatus status);
[[nodiscard]] std::string_view name(DetectionState state);

}  // namespace fantail::core
