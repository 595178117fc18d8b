// SPDX-License-Identifier: MIT
#pragma once

#include "identify/identification.hpp"

namespace fantail::identify {

struct ClosedLoopGrid {
  Model model;          ///< of the least mean absolute angle error: the published rule
  Model least_squares;  ///< of the least sum of squares: where a continuous fit may go on
  ErrorMap errors;
};

/// Eq 22 with the controller in the loop: nodes by least squares for every alpha and beta of the grid.
[[nodiscard]] ClosedLoopGrid search_closed_loop_grid(const Record& record, const Airframe& airframe,
                                                     const ClosedLoop& loop, const NodeTimes& node_time_s, Start start,
                                                     const Grid& grid);

}  // namespace fantail::identify
