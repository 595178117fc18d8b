// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "plot/drawing.hpp"
#include "plot/heat_map.hpp"

namespace fantail::plot {

/// Rings with labels that cover neither each other nor a ring; a label that had to move away is tied to its ring by a
/// line. Spots outside the axes are left out.
void draw_spots(Drawing& drawing, const std::vector<HeatMap::Spot>& spots);

}  // namespace fantail::plot
