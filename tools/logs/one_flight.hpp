// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "flight/flight.hpp"
#include "flight_log/flight_log.hpp"

namespace fantail::logs {

// A folder whose files are of two flights would make a page about neither. All throw text::Error (bad_data). The first
// two know nothing of a folder without summary.json.

/// The folder's flight.ftl is the log that summary.json was written with.
void expect_log_of_summary(const std::filesystem::path& folder);

/// The rows of the folder's flight.csv begin and end control when summary.json says so, and turn as far in between.
/// They may be a part of the flight's.
void expect_rows_of_summary(const flight::Flight& rows, const std::filesystem::path& folder);

/// The rows of the folder's flight.csv have the roll commands and roll angles of its flight.ftl under control, as far
/// as both have them: but for how the table is rounded, and for whole turns. Their clocks may have different zeros.
/// Without summary.json they are under control for as long as the log says, too. `log` holds one flight.
void expect_rows_of_log(const flight::Flight& rows, const flight_log::LogFile& log,
                        const std::filesystem::path& folder);

}  // namespace fantail::logs
