// SPDX-License-Identifier: MIT
#pragma once

#include "input/document.hpp"
#include "sim/vehicle.hpp"

namespace fantail::input {

/// Centres of gravity and inertias of an [airframe] that no rocket of this mass, length and propellant can have. Only
/// for a vehicle with an airframe whose places lie within its length. Throws text::Error (bad_configuration).
void check_balance(const Document& document, const sim::Vehicle& vehicle);

}  // namespace fantail::input
