// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "report/numbers.hpp"

namespace fantail::tunnel {

using Json = nlohmann::ordered_json;

/// Eight significant decimals behind the point: turbulence in m/s has four zeros of its own.
inline Json rounded(double value) {
  const double r = std::round(value * 1e8) / 1e8;
  return r == 0.0 ? 0.0 : r;
}
inline Json number(const std::optional<double>& value) { return value ? rounded(*value) : Json{}; }
inline Json angle(double radians) { return rounded(report::degrees(radians)); }

/// A file's name may hold any bytes.
inline std::string text_of(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace fantail::tunnel
