// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/flight.hpp"

namespace fantail::report {

/// The roll angle of a flight as one SVG: phase bands, event lines, reference, settle point, truth and estimate.
/// Complete in itself (an image file, or inside HTML), light and dark, no script.
[[nodiscard]] std::string overview_svg(const Flight& flight);

}  // namespace fantail::report
