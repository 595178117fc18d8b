// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "flight/flight.hpp"
#include "flight_log/flight_log.hpp"
#include "logs/read_csv.hpp"

namespace fantail::logs {

/// `path` itself, or of a folder its flight.csv, or else its flight.ftl. Throws text::Error (no_such_input) for a
/// folder without either.
[[nodiscard]] std::filesystem::path flight_file(const std::filesystem::path& path);

/// Which airframe a flight of fantail fly was flown with, as the summary.json beside it says; `path` is its folder, or
/// flight.csv or flight.ftl in it. Empty for every other log. Throws text::Error (bad_data) for a damaged summary, and
/// as expect_one_flight() does: of a folder's flight.csv the rows are for read_roll_log() to look at; named by itself
/// it is read as `reading` says.
[[nodiscard]] std::optional<flight::FlownAirframe> flown_airframe(const std::filesystem::path& path,
                                                                  const Reading& reading);

/// The plan of a flight: of the flight log at `path`, or of the one beside the flight.csv of fantail fly; `path` may be
/// their folder. Empty where there is no such log, or none of one flight with a plan. Throws text::Error when it is
/// none, and as flown_airframe() does.
[[nodiscard]] std::optional<core::FlightPlan> flown_plan(const std::filesystem::path& path, const Reading& reading);

/// A table at `path`, which is as flown_plan() has it, does not lie beside the log of another flight, as far as these
/// rows of it tell. Throws text::Error (bad_data).
void expect_rows_of_log_beside(const flight::Flight& rows, const std::filesystem::path& path);

/// A flight log (.ftl) by its name.
[[nodiscard]] bool is_flight_log(const std::filesystem::path& path);

/// The one flight in a log, replayed. Throws text::Error: no_such_input; bad_data when it holds no flight, several,
/// or none that can be replayed, saying what can be done about it.
[[nodiscard]] flight::Flight read_flight_log(const std::filesystem::path& file);
[[nodiscard]] flight::Flight replayed_flight(const flight_log::LogFile& log);

/// A log (.ftl), a table with the columns of flight.csv (files/load.hpp), or a folder of fantail fly: its flight.csv
/// (which has the truth too) with what summary.json says and with the plan of flight.ftl, or that log alone. Throws
/// text::Error.
[[nodiscard]] flight::Flight read_flight(const std::filesystem::path& path);

// A folder whose files are of two flights would make a page about neither. Both throw text::Error (bad_data).

/// What there is of flight.csv, flight.ftl and summary.json in the folder is of one flight. `rows` are those of its
/// flight.csv, and may be a part of the flight's; null: it has none, or they are not used. By summary.json they begin
/// and end control when it says so, and turn as far in between, and it was written with that flight.ftl. And
/// expect_rows_of_log().
void expect_one_flight(const std::filesystem::path& folder, const flight::Flight* rows);

/// The rows of the folder's flight.csv have the roll commands and roll angles of its flight.ftl under control, as far
/// as both have them: except for rounding in the table and whole turns. Their clocks may have different zeros.
/// Without summary.json they are under control for as long as the log says, too. `log` holds one flight.
void expect_rows_of_log(const flight::Flight& rows, const flight_log::LogFile& log,
                        const std::filesystem::path& folder);

}  // namespace fantail::logs
