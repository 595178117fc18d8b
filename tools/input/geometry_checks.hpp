// SPDX-License-Identifier: MIT
#pragma once

#include "input/document.hpp"
#include "sim/vehicle.hpp"

namespace fantail::input {

/// Refuses a shape that cannot be: parts outside the rocket, lists of unequal length, keys that need others, and a
/// shape that is not the one of [airframe]. Throws text::Error.
void check_geometry(const Document& document, const sim::Vehicle& vehicle);

}  // namespace fantail::input
