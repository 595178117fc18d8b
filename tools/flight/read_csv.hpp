// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "flight/flight.hpp"
#include "flight/table.hpp"
#include "flight/units.hpp"

namespace fantail::flight {

/// Fantail's name of a column and what a file calls it: {"roll_angle_deg", "phi"}. Names are those of flight.csv
/// without the true_ columns, and phase.
using ColumnNames = std::map<std::string, std::string>;

enum class AngleUnit : std::uint8_t { degrees, radians };

/// Fantail's name of a column and the unit that the file has it in.
using ColumnUnits = std::map<std::string, Unit>;

/// How a table is to be read.
struct Reading {
  ColumnNames columns{};                  ///< those that the file names differently
  ColumnUnits units{};                    ///< those that are in a unit of their own
  AngleUnit angles = AngleUnit::degrees;  ///< of every other angle and rate in the file
  bool truth = false;  ///< of a simulated flight the true_ columns are asked for, where there are any
  /// How the options of the verb begin, for advice: --column, or --a-column. Empty: it has none.
  std::string options = "--";
};

/// The columns that a user of a log cannot do without. time_s is always needed.
struct Needs {
  bool roll_angle = true;
  bool roll_rate = true;
  bool canard = false;
  bool speed = false;
};

/// A table with the columns of flight.csv, or some of them, as a flight: rows in SI and radians, phases and the events
/// that phases tell. What the table does not have is not known in the flight either.
///
/// A row with a cell that is no number in a needed column is left out; such a cell of any other column is unknown. A
/// row that repeats the one before it, time and all, counts once: loggers write a line twice, and the second says
/// nothing new. A column phase with a word that is no phase is not used. Each of these becomes a note of the flight,
/// and so do columns that Fantail does not know, and a unit that nobody stated for a column with another name.
///
/// Throws text::Error: bad_configuration for a name in `reading.columns` that Fantail does not know; bad_data for a
/// needed or mapped column that is not there (naming it and listing those that are), for nothing that Fantail knows,
/// control or a launch after control, which is another flight, time that goes back, two different rows with one time
/// (nobody knows which is right), more than 1 % of rows without a number, no row. Messages name file and line.
[[nodiscard]] Flight read_flight_csv(const Table& table, const Reading& reading, const Needs& needs);

}  // namespace fantail::flight
