// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flight/flight.hpp"

namespace fantail::report {

/// "3.2", or "any" where no factor makes the loop swing. A loop with an integrator can be one that swings with less
/// gain, not with more, and then that is said: "0.4, and swings with less".
[[nodiscard]] std::string gain_margin_text(const flight::LoopMargin& margin);

}  // namespace fantail::report
