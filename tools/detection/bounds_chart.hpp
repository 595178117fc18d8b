// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "detection/report.hpp"

namespace fantail::detection {

/// False actuations with both accelerometers well as an SVG: a row for each kind of event and in it a bar for each
/// rule, up to the 95 % bound of their share, with a dot at what was counted. On a scale of decades, so that none of
/// ten thousand and none of ten million look different. Empty without events. `width` as in page::Chart.
[[nodiscard]] std::string bounds_svg(const Report& report, double width);

}  // namespace fantail::detection
