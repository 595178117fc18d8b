// SPDX-License-Identifier: MIT
#pragma once

#include "identify/model/open_loop.hpp"

namespace fantail::identify::model {

/// The published search as one would write it without a thought: at every alpha and beta a non-linear least squares
/// (Levenberg-Marquardt with differences of whole simulations) finds the nodes. What the fast search is held against.
[[nodiscard]] GridResult search_by_brute_force(const Record& record, const Airframe& airframe, const NodeTimes& nodes,
                                               const Grid& grid);

}  // namespace fantail::identify::model
