// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "files/load.hpp"
#include "files/rows.hpp"
#include "files/sources.hpp"
#include "flight/flight.hpp"
#include "flight/table.hpp"

namespace fantail::logs {

enum class AngleUnit : std::uint8_t { degrees, radians };

/// How a table is to be read.
struct Reading {
  files::Sources columns{};               ///< those that the file names differently, or has in a unit of their own
  AngleUnit angles = AngleUnit::degrees;  ///< of every angle and rate in the file for which no unit is stated
  bool truth = false;  ///< of a simulated flight the true_ columns are asked for, where there are any
  /// How the options of the verb begin, for advice: --columns, or --a-columns. Empty: it has none.
  std::string options = "--";
};

/// Makes a reading follow the columns that are kept beside a log (files/sources.hpp), except those that it has
/// already. Returns a sentence that says so, or nothing.
[[nodiscard]] std::string follow_kept_sources(const std::filesystem::path& log, Reading& reading);

/// The columns that a user of a log cannot do without. time_s is always needed.
struct Needs {
  bool roll_angle = true;
  bool roll_rate = true;
  bool canard = false;
  bool speed = false;
};

/// A table with the columns of flight.csv, or some of them, as a flight: rows in SI and radians, phases and the events
/// that phases tell. What the table does not have is not known in the flight either. The columns of a logger of
/// files::loggers() are known where the reading names none.
///
/// Rows count as files::read_rows() says, with identical rows of one time. A cell that is no number is unknown. A
/// column phase with a word that is no phase is not used. Each of these becomes a note of the flight, and so do columns
/// that Fantail does not know, and a unit that nobody stated for a column with another name.
///
/// Throws text::Error (bad_data): as read_rows() does; for a needed or mapped column that is not there, is no column or
/// is in another unit by the file's own word (naming it and listing those that are), for nothing that Fantail knows, no
/// row, control or a launch after control, which is another flight. Messages name file and line.
[[nodiscard]] flight::Flight read_flight_csv(const files::Loaded& table, const Reading& reading, const Needs& needs);

/// The flight phases that stand as words in a column. One with a word that is no phase is not used, and a note of the
/// flight says so.
void read_phases(const flight::Table& table, const files::Rows& rows, std::size_t column, flight::Flight& flight);

/// What the phases of the rows tell of the events. Throws text::Error (bad_data) for a table, called `name`, of more
/// than one flight.
void note_phases(flight::Flight& flight, const std::string& name);

}  // namespace fantail::logs
