// SPDX-License-Identifier: MIT
#pragma once

#include "airframe/summary.hpp"
#include "sim/vehicle.hpp"

namespace fantail::airframe {

/// Holds a vehicle that was read from a design file against what that file has stored of it. The sentence of a summary
/// that has been judged then says where they differ by more than 2 % of mass or 0.2 calibres, what was left out of the
/// design, or that there was nothing to compare with. Another vehicle's summary stays as it is.
void compare_with_design(Summary& summary, const sim::Vehicle& vehicle);

}  // namespace fantail::airframe
