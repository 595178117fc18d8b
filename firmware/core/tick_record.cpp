// SPDX-License-Identifier: MIT
#include "core/tick_record.hpp"

namespace fantail::core {

std::string_view name(Phase phase) {
  switch (phase) {
    case Phase::safe: return "safe";
    case Phase::armed: return "armed";
    case Phase::launched: return "launched";
    case Phase::controlling: return "controlling";
    case Phase::finished: return "finished";
    case Phase::dormant: return "dormant";
  }
  return "unknown";
}

std::string_view name(PhaseReason reason) {
  switch (reason) {
    case PhaseReason::power_on: return "power_on";
    case PhaseReason::armed_by_switch_and_command: return "armed_by_switch_and_command";
    case PhaseReason::disarmed_by_switch: return "disarmed_by_switch";
    case PhaseReason::launch_detected: return "launch_detected";
    case PhaseReason::guide_clear: return "guide_clear";
    case PhaseReason::tunnel_start_command: return "tunnel_start_command";
    case PhaseReason::guide_not_cleared_in_time: return "guide_not_cleared_in_time";
    case PhaseReason::gyro_failed_before_control: return "gyro_failed_before_control";
    case PhaseReason::timing_fault_before_control: return "timing_fault_before_control";
    case PhaseReason::control_time_over: return "control_time_over";
    case PhaseReason::apogee: return "apogee";
    case PhaseReason::tilted_too_far: return "tilted_too_far";
    case PhaseReason::gyro_failed: return "gyro_failed";
    case PhaseReason::timing_fault: return "timing_fault";
    case PhaseReason::canard_fault: return "canard_fault";
    case PhaseReason::memory_fault: return "memory_fault";
    case PhaseReason::moved_without_launch: return "moved_without_launch";
    case PhaseReason::rested: return "rested";
    case PhaseReason::flew_without_launch: return "flew_without_launch";
    case PhaseReason::gate_open: return "gate_open";
    case PhaseReason::gate_closed_again: return "gate_closed_again";
    case PhaseReason::gate_never_opened: return "gate_never_opened";
    case PhaseReason::aborted: return "aborted";
  }
  return "unknown";
}

std::string_view name(CanardVerdict verdict) {
  switch (verdict) {
    case CanardVerdict::healthy: return "healthy";
    case CanardVerdict::dead: return "dead";
    case CanardVerdict::stalled: return "stalled";
    case CanardVerdict::slipping: return "slipping";
    case CanardVerdict::disagreeing: return "disagreeing";
  }
  return "unknown";
}

std::string_view name(SensorState state) {
  switch (state) {
    case SensorState::fresh: return "fresh";
    case SensorState::coasting: return "coasting";
    case SensorState::lost: return "lost";
    case SensorState::failed: return "failed";
  }
  return "unknown";
}

std::string_view name(BarometerState state) {
  switch (state) {
    case BarometerState::silent: return "silent";
    case BarometerState::on_pad: return "on_pad";
    case BarometerState::used: return "used";
    case BarometerState::too_fast: return "too_fast";
    case BarometerState::disagrees: return "disagrees";
    case BarometerState::alone: return "alone";
  }
  return "unknown";
}

std::string_view name(GyroVote vote) {
  switch (vote) {
    case GyroVote::both: return "both";
    case GyroVote::first: return "first";
    case GyroVote::second: return "second";
    case GyroVote::disagree: return "disagree";
    case GyroVote::neither: return "neither";
  }
  return "unknown";
}

std::string_view name(CommandStatus status) {
  switch (status) {
    case CommandStatus::outside_control: return "outside_control";
    case CommandStatus::controlling: return "controlling";
    case CommandStatus::gyro_lost: return "gyro_lost";
    case CommandStatus::not_finite: return "not_finite";
  }
  return "unknown";
}

std::string_view name(DetectionState state) {
  switch (state) {
    case DetectionState::quiet: return "quiet";
    case DetectionState::holding: return "holding";
    case DetectionState::detected: return "detected";
    case DetectionState::bad_sample: return "bad_sample";
    case DetectionState::disagreement: return "disagreement";
  }
  return "unknown";
}

}  // namespace fantail::core
