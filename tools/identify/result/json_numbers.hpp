// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "identify/result/findings.hpp"
#include "json/value.hpp"

namespace fantail::identify::result {

/// Eight digits: more than any of these numbers is known to, and no ...0000001. What is no number becomes null.
[[nodiscard]] double rounded(double value);

[[nodiscard]] json::Value list(const std::vector<double>& values, double scale = 1.0);

/// An open end is null.
[[nodiscard]] json::Value pair(const Interval& interval, double scale = 1.0);

}  // namespace fantail::identify::result
