// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/tick_record.hpp"
#include "logs/table.hpp"

namespace fantail::logs {

/// What a file calls a column and what Fantail calls it.
using ColumnNames = std::map<std::string, std::string>;  ///< e.g. {"roll_angle_deg", "phi"}

enum class AngleUnit : std::uint8_t { degrees, radians };

struct Reading {
  ColumnNames columns{};                  ///< for those that the file names differently
  AngleUnit angles = AngleUnit::degrees;  ///< of every angle and rate in the file
  bool truth = false;                     ///< read the true_ columns of a simulated flight instead of the measured ones
};

/// Roll motion over time, from a CSV file or a Fantail flight folder, in SI and radians. Every list that is not empty
/// is as long as time_s; what a file does not have is empty. Rows with a cell that is no number in a column that the
/// user needs are left out and counted; such a cell of any other column becomes not-a-number. A row that repeats the
/// one before it, time and all, is counted once: loggers write a line twice, and the second says nothing new. Roll
/// angles that are wrapped into one turn are continued.
struct RollLog {
  std::string name;            ///< file or folder as the person wrote it
  std::vector<double> time_s;  ///< strictly increasing
  std::vector<double> roll_angle_rad;
  std::vector<double> roll_rate_rad_s;
  std::vector<double> canard_rad;  ///< mean of the encoders
  std::vector<double> speed_m_s;
  std::vector<double> command_rad;
  std::vector<double> reference_rad;
  std::vector<double> excitation_rad;
  std::vector<double> height_m;
  std::vector<double> specific_force_m_s2;  ///< axial
  std::vector<core::Phase> phase;
  std::optional<double> burnout_s;  ///< from summary.json of a flight folder
  std::optional<double> apogee_s;   ///< likewise
  std::size_t rows_left_out = 0;
  std::size_t rows_repeated = 0;
  std::vector<std::string> warnings;  ///< a sentence each: angles that look like radians, rows left out, ...
};

/// The columns that a user of a log cannot do without. time_s is always needed.
struct Needs {
  bool roll_angle = true;
  bool roll_rate = true;
  bool canard = false;
  bool speed = false;
};

/// `path` is a CSV file, a flight log (.ftl), or a folder that holds a flight.csv or else a flight.ftl. A flight log is
/// read as the flight.csv that its replay makes, and what it has lost becomes a warning. Throws sim::InputError:
/// no_such_input; bad_configuration for a mapped column that Fantail does not know, and for a column, a unit or a truth
/// that is asked of a flight log; bad_data for a missing column (naming it and listing those that are
/// there), time that goes back, two different rows with one time (nobody knows which of them is right), more than 1 %
/// of rows without a number, fewer than two rows. Messages name file and line.
[[nodiscard]] RollLog read_roll_log(const std::filesystem::path& path, const Reading& reading, const Needs& needs);

/// The same from a CSV alone.
[[nodiscard]] RollLog make_roll_log(const Table& table, const Reading& reading, const Needs& needs);

}  // namespace fantail::logs
