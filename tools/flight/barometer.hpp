// SPDX-License-Identifier: MIT
#pragma once

#include "flight/flight.hpp"

namespace fantail::flight {

/// Of note_tick(), after the phase: Flight::barometer_spells. A launch that was none leaves nothing.
void note_barometer(Flight& flight, const core::TickRecord& record, double time_s);

}  // namespace fantail::flight
