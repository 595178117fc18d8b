// SPDX-License-Identifier: MIT
#include "flight/phase_names.hpp"

#include <fmt/core.h>

#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::flight {

std::string display_name(core::Phase phase) {
  std::string name{core::name(phase)};
  name.front() = static_cast<char>(name.front() - 'a' + 'A');
  return name;
}

std::string_view display_name(core::PhaseReason reason) {
  using core::PhaseReason;
  switch (reason) {
    case PhaseReason::power_on: return "power on";
    case PhaseReason::armed_by_switch_and_command: return "armed by switch and command";
    case PhaseReason::disarmed_by_switch: return "disarmed by the switch";
    case PhaseReason::launch_detected: return "launch detected";
    case PhaseReason::guide_clear: return "guide clear and fast enough";
    case PhaseReason::tunnel_start_command: return "start command in the tunnel";
    case PhaseReason::guide_not_cleared_in_time: return "the guide was not cleared in time";
    case PhaseReason::gyro_failed_before_control: return "the gyro failed before control";
    case PhaseReason::timing_fault_before_control: return "a timing fault before control";
    case PhaseReason::control_time_over: return "control time over";
    case PhaseReason::apogee: return "apogee";
    case PhaseReason::tilted_too_far: return "the rocket tilted too far";
    case PhaseReason::gyro_failed: return "the gyro failed";
    case PhaseReason::timing_fault: return "a timing fault";
    case PhaseReason::canard_fault: return "a canard fault";
    case PhaseReason::memory_fault: return "damaged memory";
    case PhaseReason::moved_without_launch: return "moved without a launch, must rest";
    case PhaseReason::rested: return "at rest again";
    case PhaseReason::flew_without_launch: return "flew without a detected launch";
    case PhaseReason::gate_open: return "the plan's gate opened";
    case PhaseReason::gate_closed_again: return "the plan's gate closed again";
    case PhaseReason::gate_never_opened: return "the plan's gate did not open";
    case PhaseReason::aborted: return "aborted by the abort input";
  }
  return "unknown";
}

std::string why_it_began(std::optional<core::PhaseReason> reason, bool is_there_when_log_begins) {
  std::string why{reason ? display_name(*reason) : ""};
  if (!is_there_when_log_begins) {
    return why;
  }
  return "already when the log begins" + (why.empty() ? "" : fmt::format(" ({})", why));
}

std::string imposed_roll_sentence(const Flight& flight) {
  if (!flight.imposed_roll) {
    return {};
  }
  const ImposedRoll& imposed = *flight.imposed_roll;
  return fmt::format("Roll was imposed by the scenario at {} s: angle {} deg, rate {} deg/s.",
                     text::fixed(imposed.time_s, 2), text::fixed(text::degrees(imposed.angle_rad), 1),
                     text::fixed(text::degrees(imposed.rate_rad_s), 1));
}

}  // namespace fantail::flight
