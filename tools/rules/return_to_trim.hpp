// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "flight/flight.hpp"
#include "rules/figures.hpp"
#include "rules/record.hpp"

namespace fantail::rules {

/// flight.tilt_off_trim_deg and flight.off_trim_after_abort, of a flight with a known plan. `ascent` are its rows up to
/// the end of the ascent; `missing` is where some are not there.
[[nodiscard]] Findings return_to_trim(const flight::Flight& flight, std::span<const flight::Row> ascent,
                                      const std::vector<Hole>& missing);

}  // namespace fantail::rules
