// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/figures.hpp"
#include "report/flight.hpp"

namespace fantail::report {

// The parts of the page that are numbers and words, as HTML; everything that comes from files is escaped.

[[nodiscard]] std::string figure_list(const Flight& flight, const Figures& figures);
[[nodiscard]] std::string phase_legend(const Flight& flight);
[[nodiscard]] std::string event_table(const Flight& flight);
[[nodiscard]] std::string phase_table(const Flight& flight);
/// Empty when no canard monitor spoke.
[[nodiscard]] std::string canard_table(const Flight& flight);
[[nodiscard]] std::string assumption_list(const Flight& flight);

}  // namespace fantail::report
