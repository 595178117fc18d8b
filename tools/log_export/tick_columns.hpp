// SPDX-License-Identifier: MIT
#pragma once

#include "files/column.hpp"
#include "log_export/fields.hpp"
#include "log_export/replayed_flight.hpp"

namespace fantail::log_export {

/// The chosen fields, a value for each tick of the log. The words of a column stand in the order of their enumeration.
[[nodiscard]] files::Columns tick_columns(const ReplayedFlight& source, const Selection& selection);

}  // namespace fantail::log_export
