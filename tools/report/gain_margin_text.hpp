// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "flight/flight.hpp"

namespace fantail::report {

/// "3.2 times", or "any" where no factor makes the loop swing. A loop with an integrator can be one that swings with
/// less gain, not with more, and then that is said: "0.4 times, and swings with less".
[[nodiscard]] std::string gain_margin_text(const flight::LoopMargin& margin);

/// Those of a flight that differ when speed and phase margin are printed as whole numbers; of others the worst.
[[nodiscard]] std::vector<flight::LoopMargin> different_margins(const flight::Flight& flight);

}  // namespace fantail::report
