// SPDX-License-Identifier: MIT
#pragma once

#include "input/document.hpp"
#include "sim/vehicle.hpp"

namespace fantail::input {

/// Centres of gravity and inertias of an [airframe] that no rocket of this mass, length and propellant can have. For a
/// flight that they decide: in another one, a mass or motor that is changed alone is a fair question. `document` is the
/// vehicle's; it has an airframe. Throws text::Error (bad_configuration).
void check_balance(const Document& document, const sim::Vehicle& vehicle);

}  // namespace fantail::input
