// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

// Alpha and beta go with one over the reference area, so a rocket may have 20 m2 or 0.0002 m2.
namespace fantail::identify::result {

/// Decimals that show so many digits of a number, from the first that is not zero.
[[nodiscard]] int decimals_for(double value, int digits);

/// "22.87", "0.1304": two decimals, or four digits where
/// those would tell less.
[[nodiscard]] std::string constant_text(double value);

/// "0.1467 m2 instead of 0.1304": as many digits as tell the two apart. "0.1121 m as before" where that takes more than
/// anybody can measure.
[[nodiscard]] std::string change_text(double now, double before, std::string_view unit);

}  // namespace fantail::identify::result
