// SPDX-License-Identifier: MIT
#pragma once

#include "log_export/fields.hpp"
#include "log_export/replayed_flight.hpp"
#include "table_file/column.hpp"

namespace fantail::log_export {

/// The chosen fields, a value for each tick of the log. The words of a column stand in the order of their enumeration.
[[nodiscard]] table_file::Columns tick_columns(const ReplayedFlight& source, const Selection& selection);

}  // namespace fantail::log_export
