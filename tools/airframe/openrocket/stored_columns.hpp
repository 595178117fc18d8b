// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace fantail::airframe::openrocket {

/// What is read of the series of numbers that OpenRocket stores of a flight.
enum Quantity : std::uint8_t { mass, gravity, pressure, margin, angle, mach, climb, quantities };

/// The names of its column: in later versions a key, up to then a word of the language that its user had.
[[nodiscard]] const std::array<std::span<const std::string_view>, quantities>& stored_columns();

}  // namespace fantail::airframe::openrocket
