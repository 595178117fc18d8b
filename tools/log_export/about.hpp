// SPDX-License-Identifier: MIT
#pragma once

#include "json/value.hpp"
#include "log_export/fields.hpp"
#include "log_export/replayed_flight.hpp"

namespace fantail::log_export {

/// Everything that a log says and that is not of a single tick: what its header says, the plan, gaps, events, health,
/// and under "columns" unit and description of each chosen field. Null: unknown.
[[nodiscard]] json::Value about(const ReplayedFlight& source, const Selection& selection);

}  // namespace fantail::log_export
