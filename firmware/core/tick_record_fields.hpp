// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <string_view>
#include <type_traits>

#include "core/tick_record.hpp"

namespace fantail::core {

/// Name and unit of one signal of a tick, as they stand in every file. Angles are radians here and degrees at the
/// edges.
struct SignalName {
  std::string_view name;  ///< without the unit; a canard's ends with its number, 1 to 4
  std::string_view unit;  ///< "rad", "m_s2", "us", ...; empty for what has none
};

/// Shows every signal of a record once, in a fixed order: the one list that a digest, an export and a comparison go by.
/// The visitor is called with the name and a value: Angle, std::optional<Angle>, float, bool, std::uint32_t,
/// Microseconds, an enumeration or std::optional of GyroVote or BarometerState, which is no signal where it is empty;
/// for a record that may be written, so may what the visitor is shown.
template <typename Record, typename Visitor>
  requires std::same_as<std::remove_const_t<Record>, TickRecord>
void visit_signals(Record& record, Visitor&& visit) {
  visit(SignalName{"time", "us"}, record.time);
  visit(SignalName{"phase", ""}, record.phase);
  visit(SignalName{"reason", ""}, record.reason);
  visit(SignalName{"detection", ""}, record.detection);
  visit(SignalName{"command_status", ""}, record.command_status);
  visit(SignalName{"timing_fault", ""}, record.timing_fault);
  visit(SignalName{"overruns", ""}, record.overruns);

  auto& motion = record.motion;
  visit(SignalName{"roll_angle", "rad"}, motion.roll_angle);
  visit(SignalName{"roll_rate", "rad_s"}, motion.roll_rate_rad_s);
  visit(SignalName{"specific_force_x", "m_s2"}, motion.specific_force_m_s2.x);
  visit(SignalName{"specific_force_y", "m_s2"}, motion.specific_force_m_s2.y);
  visit(SignalName{"specific_force_z", "m_s2"}, motion.specific_force_m_s2.z);
  visit(SignalName{"height", "m"}, motion.height_m);
  visit(SignalName{"distance_along_guide", "m"}, motion.distance_along_guide_m);
  visit(SignalName{"speed", "m_s"}, motion.speed_m_s);
  visit(SignalName{"vertical_speed", "m_s"}, motion.vertical_speed_m_s);
  visit(SignalName{"tilt", "rad"}, motion.tilt);
  visit(SignalName{"tilt_from_guide", "rad"}, motion.tilt_from_guide);
  visit(SignalName{"gyro_state", ""}, motion.gyro);
  visit(SignalName{"accelerometer_state", ""}, motion.accelerometer);
  visit(SignalName{"rate_is_lower_bound", ""}, motion.rate_is_lower_bound);
  visit(SignalName{"roll_is_bridged", ""}, motion.roll_is_bridged);
  visit(SignalName{"speed_is_lower_bound", ""}, motion.speed_is_lower_bound);
  visit(SignalName{"gyro_vote", ""}, record.gyro_vote);
  visit(SignalName{"barometer_state", ""}, record.barometer_state);
  visit(SignalName{"at_rest_for", "us"}, motion.at_rest_for);
  visit(SignalName{"thrust_since", "us"}, motion.thrust_since);

  visit(SignalName{"reference", "rad"}, record.reference);
  visit(SignalName{"excitation", "rad"}, record.excitation);
  visit(SignalName{"offset_estimate", "rad"}, record.offset_estimate);
  visit(SignalName{"unclamped_command", "rad"}, record.unclamped_command);
  visit(SignalName{"command", "rad"}, record.command);
  visit(SignalName{"saturated", ""}, record.saturated);

  struct CanardNames {
    std::string_view command, pulse, driven, limited, encoder, verdict;
  };
  constexpr std::array<CanardNames, canard_count> names{{
      {"command_1", "pulse_1", "driven_1", "limited_1", "encoder_1", "verdict_1"},
      {"command_2", "pulse_2", "driven_2", "limited_2", "encoder_2", "verdict_2"},
      {"command_3", "pulse_3", "driven_3", "limited_3", "encoder_3", "verdict_3"},
      {"command_4", "pulse_4", "driven_4", "limited_4", "encoder_4", "verdict_4"},
  }};
  for (std::size_t i = 0; i < canard_count; ++i) {
    visit(SignalName{names[i].command, "rad"}, record.canards[i].angle);
    visit(SignalName{names[i].pulse, "us"}, record.canards[i].pulse_us);
    visit(SignalName{names[i].driven, ""}, record.canards[i].driven);
    visit(SignalName{names[i].limited, ""}, record.canards[i].limited);
    visit(SignalName{names[i].encoder, "rad"}, record.encoders[i]);
    visit(SignalName{names[i].verdict, ""}, record.verdicts[i]);
  }
  visit(SignalName{"canard", "rad"}, record.canard_angle);
}

}  // namespace fantail::core
