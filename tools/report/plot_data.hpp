// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/flight.hpp"

namespace fantail::report {

/// What page.js draws, as JSON: phase bands, event marks, and for each plot its times and values, thinned without
/// losing a peak. Times in seconds, angles in degrees, rounded to what a plot can show; null where nothing was known.
[[nodiscard]] std::string plot_data(const Flight& flight);

}  // namespace fantail::report
