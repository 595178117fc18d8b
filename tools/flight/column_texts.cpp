// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "flight/columns.hpp"

namespace fantail::flight {
namespace {

struct Text {
  std::string_view name;  ///< # stands for the number of a canard
  std::string_view unit;
  std::string_view description;
};

// clang-format off: one column a row reads better than one argument a line
constexpr auto texts = std::to_array<Text>({
  // The clock, and what the avionics knew and did.
  {"time_s", "s", "time since lift-off (tunnel: since control start)"},
  {"time_us", "us", "the avionics' own clock, since power-up"},
  {"phase", "-", "phase of the flight: safe, armed, launched, dormant, controlling, finished"},
  {"reason", "-", "why this phase began"},
  {"detection", "-", "state of the launch detector"},
  {"command_status", "-", "reason for the roll command"},
  {"timing_fault", "-", "1: the time of this tick makes it doubtful"},
  {"overruns", "-", "missed ticks, since power-up"},
  {"roll_angle_deg", "deg", "roll angle since launch detection (tunnel: since control start), not wrapped"},
  {"roll_rate_deg_s", "deg/s", "roll rate, bias subtracted"},
  {"specific_force_m_s2", "m/s2", "specific force along the axis towards the nose"},
  {"specific_force_y_m_s2", "m/s2", "specific force along the rocket's y axis"},
  {"specific_force_z_m_s2", "m/s2", "specific force along the rocket's z axis"},
  {"height_m", "m", "estimated height above the place of lift-off"},
  {"distance_along_guide_m", "m", "estimated distance along the launch guide"},
  {"speed_m_s", "m/s", "estimated speed along the guide"},
  {"vertical_speed_m_s", "m/s", "estimated vertical speed, upwards positive"},
  {"tilt_deg", "deg", "estimated angle between axis and vertical"},
  {"tilt_from_guide_deg", "deg", "estimated angle between the axis and where it pointed at rest"},
  {"gyro_state", "-", "fresh, coasting, lost or failed"},
  {"accelerometer_state", "-", "fresh, coasting, lost or failed"},
  {"rate_is_lower_bound", "-", "1: the gyro is at the end of its range"},
  {"roll_is_bridged", "-", "1: the roll angle went over a gap or a range that was not measured"},
  {"speed_is_lower_bound", "-", "1: height and speed are lower bounds, an accelerometer was at the end of its range"},
  {"barometer_state", "-", "of the barometer: silent, on_pad, used, too_fast, disagrees or alone"},
  {"gyro_vote", "-", "of two gyros: both (agree, the first flies), first, second, disagree or neither"},
  {"at_rest_for_us", "us", "how long the rocket has been at rest"},
  {"thrust_since_us", "us", "when the specific force last left 1 g, on the avionics' clock"},
  {"reference_deg", "deg", "roll angle that the plan commands, R"},
  {"excitation_deg", "deg", "chirp, a part of the roll command"},
  {"offset_estimate_deg", "deg", "estimate of the fin offset that the law subtracts from its command"},
  {"unclamped_command_deg", "deg", "roll command before the clamp"},
  {"command_deg", "deg", "roll command after the clamp: the commanded mean canard angle, positive rolls positively"},
  {"saturated", "-", "1: the clamp reduced the roll command"},
  {"command_#_deg", "deg", "commanded shaft angle of canard #; empty: its servo is switched off"},
  {"pulse_#_us", "us", "servo pulse of canard #"},
  {"driven_#", "-", "1: the servo of canard # gets pulses"},
  {"limited_#", "-", "1: the command of canard # was clamped, or held back by the first-motion rate"},
  {"encoder_#_deg", "deg", "shaft angle of canard # by its encoder; empty: no valid reading"},
  {"verdict_#", "-", "state of canard # by the monitor: healthy, dead, stalled, slipping or disagreeing"},
  {"replayed", "-", "0: no replay reached this tick, and the columns that only a replay computes are empty"},
  {"canard_deg", "deg", "mean of the encoders that can be read, from trim, positive rolls positively"},

  // What only a simulated flight knows.
  {"true_roll_angle_deg", "deg", "roll angle in the simulation, since the pad, not wrapped"},
  {"true_roll_rate_deg_s", "deg/s", "roll rate in the simulation"},
  {"true_canard_deg", "deg", "mean effective canard angle in the air, less stall and the part that the fins take back"},
  {"true_height_m", "m", "height above the pad in the simulation"},
  {"true_speed_m_s", "m/s", "speed in the simulation (tunnel: of the air; six degrees of freedom: through the air, along the axis)"},
  {"true_disturbance_deg", "deg", "canard angle that rolls the rocket as the fin misalignment does, u_d"},
  {"true_geometric_roll_deg", "deg", "roll angle as a camera sees it, since the pad, not wrapped; in six degrees of freedom only"},

  // What a flight log holds of a tick beside these.
  {"sequence", "-", "number of the record in the log"},
  {"arm_switch_closed", "-", "1: the arm switch is closed"},
  {"abort", "-", "1: the abort input asks to abort"},
  {"arm_command", "-", "1: the arm command came in this tick"},
  {"start_command", "-", "1: the tunnel's start command came in this tick"},
  {"abort", "-", "1: the abort input asked to end control, by the plan's sense of its contact"},
  {"imu_status", "-", "of the IMU's sample: ok, error or no_reading"},
  {"imu_age_us", "us", "age of the IMU's sample"},
  {"second_gyro_status", "-", "of the second gyro's sample: ok, error or no_reading"},
  {"second_gyro_age_us", "us", "age of the second gyro's sample"},
  {"second_rate_x_count", "count", "raw angular rate of the second gyro about the axis; the log's header has the scale"},
  {"second_rate_y_count", "count", "raw angular rate of the second gyro about the rocket's y axis"},
  {"second_rate_z_count", "count", "raw angular rate of the second gyro about the rocket's z axis"},
  {"pressure_pa", "Pa", "new reading of the barometer; empty in a tick without one"},
  {"pressure_age_us", "us", "age of that reading"},
  {"accelerometer_status", "-", "of the second accelerometer's sample: ok, error or no_reading"},
  {"accelerometer_age_us", "us", "age of the second accelerometer's sample"},
  {"rate_x_count", "count", "raw angular rate about the axis; the log's header has the scale"},
  {"rate_y_count", "count", "raw angular rate about y; the log's header has the scale"},
  {"rate_z_count", "count", "raw angular rate about z; the log's header has the scale"},
  {"specific_force_x_count", "count", "raw specific force of the IMU along the axis; the log's header has the scale"},
  {"specific_force_y_count", "count", "raw specific force of the IMU along y; the log's header has the scale"},
  {"specific_force_z_count", "count", "raw specific force of the IMU along z; the log's header has the scale"},
  {"accelerometer_x_count", "count", "raw specific force of the second accelerometer along the axis; the log's header has the scale"},
  {"accelerometer_y_count", "count", "raw specific force of the second accelerometer along y; the log's header has the scale"},
  {"accelerometer_z_count", "count", "raw specific force of the second accelerometer along z; the log's header has the scale"},
  {"encoder_#_count", "count", "raw angle of encoder #, 0 to 16383 in a turn"},
  {"encoder_#_status", "-", "of encoder #: ok, error or no_reading"},
  {"duration_before_us", "us", "how long the tick before took, at most 65535"},
  {"digest", "-", "checksum of all signals of the tick, by which a replay is compared"},

  // Health, ten times a second.
  {"ticks_dropped", "-", "ticks that the log could not take, since power-up"},
  {"unsent", "-", "frames that the bus did not take, since power-up"},
  {"bus_errors", "-", "errors of the bus, since power-up"},
  {"longest_tick_us", "us", "longest tick since the record before"},
  {"longest_queue", "-", "most records that waited for the flash since the record before"},
  {"bus_state", "-", "0 error active, 1 warning, 2 error passive, 3 bus off, 4 down"},
});
// clang-format on

// The number of a canard in a name: a digit of 1 to 4 that stands alone between underscores or at the end.
std::size_t place_of_number(std::string_view name) {
  for (std::size_t i = 1; i < name.size(); ++i) {
    const bool alone = name[i - 1] == '_' && (i + 1 == name.size() || name[i + 1] == '_');
    if (alone && name[i] >= '1' && name[i] <= '4') {
      return i;
    }
  }
  return std::string_view::npos;
}

}  // namespace

std::optional<ColumnText> column_text(std::string_view name) {
  std::string key{name};
  const std::size_t number = place_of_number(name);
  if (number != std::string_view::npos) {
    key[number] = '#';
  }
  const auto found = std::ranges::find(texts, key, &Text::name);
  if (found == texts.end()) {
    return {};
  }
  ColumnText text{.unit = found->unit, .description = std::string{found->description}};
  if (number != std::string_view::npos) {
    std::ranges::replace(text.description, '#', name[number]);
  }
  return text;
}

}  // namespace fantail::flight
