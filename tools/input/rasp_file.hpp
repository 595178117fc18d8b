// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "sim/thrust_curve.hpp"

namespace fantail::input {

/// Reads a motor from a RASP file (.eng): comment lines (;), then
///   name diameter_mm length_mm delays propellant_kg total_kg maker
/// and one "seconds newtons" pair a line, the last one with thrust zero. A first point after ignition means that thrust
/// rises from zero at ignition. Reads the FIRST motor of a file; what follows it is not looked at. Lines may end as on
/// Windows. Throws text::Error: no_such_input, or bad_data as "file:line: value; rule".
[[nodiscard]] sim::ThrustCurve load_rasp(const std::filesystem::path& file);

}  // namespace fantail::input
