// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "flight/flight.hpp"

namespace fantail::logs {

/// `path` itself, or of a folder its flight.csv, or else its flight.ftl. Throws text::Error (no_such_input) for a
/// folder without either.
[[nodiscard]] std::filesystem::path flight_file(const std::filesystem::path& path);

/// A flight log (.ftl) by its name.
[[nodiscard]] bool is_flight_log(const std::filesystem::path& path);

/// The one flight in a log, replayed. Throws text::Error: no_such_input; bad_data when it holds no flight, several,
/// or none that can be replayed, saying what can be done about it.
[[nodiscard]] flight::Flight read_flight_log(const std::filesystem::path& file);

/// A log (.ftl), a table with the columns of flight.csv, or a folder of fantail fly: its flight.csv (which has the
/// truth too) with what summary.json says and with the plan of flight.ftl, or that log alone. Throws text::Error.
[[nodiscard]] flight::Flight read_flight(const std::filesystem::path& path);

}  // namespace fantail::logs
