// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sim/input/field.hpp"
#include "sim/vehicle.hpp"

namespace fantail::sim::input {

/// Everything that a vehicle file may say.
[[nodiscard]] std::span<const Field<Vehicle>> vehicle_fields();

/// Reads a vehicle file, and the motor that it names: a shipped one, or a path. Throws InputError.
[[nodiscard]] Vehicle read_vehicle(const Document& document);

}  // namespace fantail::sim::input
