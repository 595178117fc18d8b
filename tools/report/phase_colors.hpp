// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "flight/flight.hpp"
#include "page/chart.hpp"

namespace fantail::report {

/// The colour of a phase behind the curves of every chart.
[[nodiscard]] page::Role color_of(core::Phase phase);

/// The phases of a flight, in order. Empty where the rows do not know them.
[[nodiscard]] std::vector<page::ShadedRange> phase_ranges(const flight::Flight& flight);

/// Puts them behind curves over the rows' clock, as far as those reach.
void shade_phases(page::Chart& chart, const flight::Flight& flight);

}  // namespace fantail::report
