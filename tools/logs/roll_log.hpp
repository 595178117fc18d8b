// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "flight/flight.hpp"
#include "logs/read_csv.hpp"

namespace fantail::logs {

/// Roll motion over time, in SI and radians. Every list that is not empty is as long as time_s; what is unknown at
/// any time is empty, at some times not-a-number. Roll angles that are wrapped into one turn are continued.
struct RollLog {
  std::string name;            ///< file or folder as the person wrote it
  std::string vehicle;         ///< that a flight log (.ftl) says it flew in; empty: this file does not say
  std::vector<double> time_s;  ///< strictly increasing
  std::vector<double> roll_angle_rad;
  std::vector<double> roll_rate_rad_s;
  std::vector<double> canard_rad;  ///< mean of the encoders
  std::vector<double> speed_m_s;
  std::vector<double> command_rad;
  std::vector<double> reference_rad;
  std::vector<double> excitation_rad;
  std::vector<double> offset_estimate_rad;  ///< what the law took off its command
  std::vector<double> estimated_speed_m_s;  ///< what the avionics knew of it, where the truth was asked for, too
  std::vector<double> height_m;
  std::vector<double> specific_force_m_s2;  ///< axial
  std::vector<core::Phase> phase;
  std::optional<double> burnout_s;
  std::optional<double> apogee_s;
  std::optional<double> speed_bound_from_s;  ///< from here on the estimates of height and speed are lower bounds
  std::vector<std::string> warnings;  ///< a sentence each: the flight's notes, angles that look like radians, ...
};

/// The roll motion of a flight, measured or true as `reading` says. Throws text::Error (bad_data) for fewer than
/// two rows.
[[nodiscard]] RollLog roll_log(const flight::Flight& flight, std::string name, const Reading& reading);

/// `path` is a table (files/load.hpp), a flight log (.ftl), or a folder that holds a flight.csv or else a flight.ftl.
/// The columns that are kept beside a table (files/sources.hpp) are followed where `reading` says nothing else. A roll
/// angle that is needed and not in the file is the integral of the roll rate. Both become warnings. Throws text::Error
/// as read_flight_csv and read_flight_log do, and bad_configuration when columns, a unit or a truth are asked of a
/// flight log.
[[nodiscard]] RollLog read_roll_log(const std::filesystem::path& path, const Reading& reading, const Needs& needs);

// What is legal but most likely not meant. Each doubt becomes a warning of the log; nothing is refused or changed.

/// Without its sign; what is not a number does not count, and of nothing it is 0.
[[nodiscard]] double largest(const std::vector<double>& list);

/// Angles whose size speaks for another unit in the file than the one that `reading` states, and samples so far apart
/// that time is likely in milliseconds.
void note_doubtful_units(RollLog& log, const Reading& reading);

/// A roll rate that is not the slope of the roll angle: of opposite sign, or off by 180 / pi.
void note_doubtful_motion(RollLog& log);

}  // namespace fantail::logs
