// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flight/flight.hpp"
#include "report/figures.hpp"

namespace fantail::report {

/// Nobody minds the last half second: near apogee there is no flow over the canards.
inline constexpr double near_apogee_s = 0.5;

/// Of a flight without control: why it never began, as far as is known.
[[nodiscard]] std::string no_control(const flight::Flight& flight);

/// Did control end before its time? The plan's own end of control is none; apogee is one when it was imagined.
[[nodiscard]] bool ended_early(const flight::Flight& flight, const Figures& f);

/// When and why control did, and what the rocket turned by until apogee: one or two sentences.
[[nodiscard]] std::string early_end(const flight::Flight& flight, const Figures& f);

}  // namespace fantail::report
