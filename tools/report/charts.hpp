// SPDX-License-Identifier: MIT
#pragma once

#include "flight/flight.hpp"
#include "page/live.hpp"

namespace fantail::report {

/// What the report shows of a flight over time: phases as stripes, events as upright levels, and in degrees, metres and
/// seconds what was known on board and what was true. The first is the roll angle. Empty without a row.
[[nodiscard]] page::LiveCharts charts(const flight::Flight& flight);

}  // namespace fantail::report
