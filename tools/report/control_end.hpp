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

/// Did control end before apogee, whatever ended it? In the tunnel, where there is no apogee: for another reason than
/// the plan's own time.
[[nodiscard]] bool ended_early(const flight::Flight& flight, const Figures& f);

/// When and why control did, and what the rocket turned by until apogee: one or two sentences.
[[nodiscard]] std::string early_end(const flight::Flight& flight, const Figures& f);

}  // namespace fantail::report
