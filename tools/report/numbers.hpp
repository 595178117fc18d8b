// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <string>
#include <string_view>

namespace fantail::report {

[[nodiscard]] constexpr double degrees(double radians) { return radians * (180.0 / std::numbers::pi); }
[[nodiscard]] constexpr double radians(double degrees) { return degrees * (std::numbers::pi / 180.0); }

/// "-7.30" for (-7.3, 2); never "-0.0". Not a number reads "not a number".
[[nodiscard]] std::string fixed(double value, int decimals);

/// The same with no trailing zeros after the point: "6", "-7.3".
[[nodiscard]] std::string brief(double value, int decimals);

/// For print, a number or a sentence with numbers: a hyphen is half as wide as a minus and gets lost before a large
/// figure.
[[nodiscard]] std::string with_minus(std::string_view text);

}  // namespace fantail::report
