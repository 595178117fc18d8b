// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "log_export/fields.hpp"
#include "log_export/source.hpp"

namespace fantail::log_export {

/// flight.csv: its columns, one row for each tick that was replayed.
[[nodiscard]] std::string flight_csv(const Source& source, const flight::Flight& report);

/// The chosen fields, one row for each tick of the log. What is unknown is an empty cell.
[[nodiscard]] std::string csv(const Source& source, const Selection& selection);

}  // namespace fantail::log_export
