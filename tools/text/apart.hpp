// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace fantail::text {

/// `value` as fixed(value, decimals), with up to three more digits while that prints the same number as `limit` does.
/// A reason such as "up to Mach 0.80, but valid only to Mach 0.8" compares two numbers that must differ in print.
[[nodiscard]] std::string apart(double value, double limit, int decimals);

}  // namespace fantail::text
