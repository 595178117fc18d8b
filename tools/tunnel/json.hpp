// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "json/value.hpp"
#include "text/degrees.hpp"

namespace fantail::tunnel {

using Json = json::Value;

/// Eight significant decimals behind the point: turbulence in m/s has four zeros of its own.
inline double rounded(double value) { return json::rounded(value, 8); }
inline std::optional<double> rounded(const std::optional<double>& value) { return json::rounded(value, 8); }
inline double angle(double radians) { return rounded(text::degrees(radians)); }

}  // namespace fantail::tunnel
