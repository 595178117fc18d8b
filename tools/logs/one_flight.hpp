// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "flight/flight.hpp"

namespace fantail::logs {

// A folder whose files are of two flights would make a page about neither. Both throw text::Error (bad_data), and know
// nothing of a folder without summary.json.

/// The folder's flight.ftl is the log that summary.json was written with.
void expect_log_of_summary(const std::filesystem::path& folder);

/// The rows of the folder's flight.csv come under control when summary.json says so.
void expect_rows_of_summary(const std::vector<flight::Row>& rows, const std::filesystem::path& folder);

}  // namespace fantail::logs
