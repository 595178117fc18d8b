// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>

#include "input/field.hpp"
#include "sim/vehicle.hpp"

namespace fantail::input {

/// Everything that a vehicle file may say.
[[nodiscard]] std::span<const Field<sim::Vehicle>> vehicle_fields();

/// Reads a vehicle file, and the motor that it names: a shipped one, or a path. Throws text::Error.
[[nodiscard]] sim::Vehicle read_vehicle(const Document& document);

/// As many of one motor, lit at once.
[[nodiscard]] sim::ThrustCurve motors(const sim::ThrustCurve& one, int count, double thrust_factor);

/// The file of the motor that the vehicle names. Throws text::Error.
[[nodiscard]] std::filesystem::path motor_file(const Document& document);

}  // namespace fantail::input
