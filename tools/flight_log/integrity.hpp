// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "flight_log/flight_log.hpp"
#include "flight_log/regenerate.hpp"

namespace fantail::flight_log {

/// Records that were written and are not there.
[[nodiscard]] std::uint64_t lost_records(const Flight& flight);
/// Records that were never written, because they found no room in the recorder's queue; as far as its events say.
[[nodiscard]] std::uint64_t dropped_records(const Flight& flight);
/// Did the recorder end the recording itself? A log without this end was cut off: by power lost on impact, mostly.
/// By the avionics in a simulated world, as the record's header says.
[[nodiscard]] bool is_simulated(const Flight& flight);

[[nodiscard]] bool has_end(const Flight& flight);

/// "the recording ends early: ...": why a log without that end has none, where the next one says it, or most likely has
/// none. A simulated rocket does not lose power: its world ends a second after apogee, its recorder half a minute
/// after control.
[[nodiscard]] std::string end_text(const Flight& flight);

/// Every record from the first to the last that was written is there. A log that was merely cut off is intact as far as
/// it goes.
[[nodiscard]] bool intact(const Flight& flight);
/// Likewise of all flights, with no bytes between them that belong to no record.
[[nodiscard]] bool intact(const LogFile& file);

/// "intact: 31 250 records, none missing".
[[nodiscard]] std::string integrity_text(const Flight& flight);
/// "342 bytes in 3 places lie outside the intact records". Empty when there are none.
[[nodiscard]] std::string foreign_bytes_text(const LogFile& file);
/// "equal: all 30 000 ticks replayed, every output byte as recorded".
[[nodiscard]] std::string replay_text(const Flight& flight, const Regeneration& regeneration);

}  // namespace fantail::flight_log
