// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "flight/flight.hpp"
#include "flight_log/flight_log.hpp"

namespace fantail::logs {

// A folder whose files are of two flights would make a page about neither. Both throw text::Error (bad_data).

/// What there is of flight.csv, flight.ftl and summary.json in the folder is of one flight. `rows` are those of its
/// flight.csv, and may be a part of the flight's; null: it has none, or they are not used. By summary.json they begin
/// and end control when it says so, and turn as far in between, and it was written with that flight.ftl. And
/// expect_rows_of_log().
void expect_one_flight(const std::filesystem::path& folder, const flight::Flight* rows);

/// The rows of the folder's flight.csv have the roll commands and roll angles of its flight.ftl under control, as far
/// as both have them: but for how the table is rounded, and for whole turns. Their clocks may have different zeros.
/// Without summary.json they are under control for as long as the log says, too. `log` holds one flight.
void expect_rows_of_log(const flight::Flight& rows, const flight_log::LogFile& log,
                        const std::filesystem::path& folder);

}  // namespace fantail::logs
