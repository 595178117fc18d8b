// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "flight/flight.hpp"
#include "flight_log/flight_log.hpp"
#include "flight_log/regenerate.hpp"

namespace fantail::flight_log {

/// The board's clock where `time_s` is 0: the start of the replayed window (Motion::thrust_since at detection), in the
/// tunnel control start; of a log that shows neither, its first tick.
[[nodiscard]] core::Microseconds time_zero(const Flight& flight, const Regeneration& regeneration);
/// What that is, behind "seconds from".
[[nodiscard]] std::string_view time_zero_text(const Flight& flight, const Regeneration& regeneration);

/// What the plan of a flight is called: the shipped one with the same checksum, else "plan 1a2b3c4d". Empty without a
/// plan block.
[[nodiscard]] std::string plan_name(const Flight& flight);

/// A logged flight as the reports, exports and analyses know a flight: a row for each regenerated tick, without truth.
/// A default-made `regeneration`, where there is no plan to replay with, gives no rows.
[[nodiscard]] flight::Flight to_report(const Flight& flight, const Regeneration& regeneration);

/// A flight in one record or, where it was resumed after resets, in several: each is the rest of the one before it.
struct Part {
  const Flight& flight;
  const Regeneration& regeneration;
};
[[nodiscard]] flight::Flight to_report(std::span<const Part> parts);

}  // namespace fantail::flight_log
