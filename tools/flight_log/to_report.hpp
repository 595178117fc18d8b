// SPDX-License-Identifier: MIT
#pragma once

#include "flight_log/flight_log.hpp"
#include "flight_log/regenerate.hpp"
#include "report/flight.hpp"

namespace fantail::flight_log {

/// A logged flight as the reports, exports and analyses know a flight: a row for each regenerated tick, without truth.
/// Time zero is the start of the replayed window (Motion::thrust_since at detection), in the tunnel control start; of a
/// log that shows neither, its first tick.
[[nodiscard]] report::Flight to_report(const Flight& flight, const Regeneration& regeneration);

}  // namespace fantail::flight_log
