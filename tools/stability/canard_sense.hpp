// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sim/scenario.hpp"

namespace fantail::stability {

/// A clause on canards that together do not turn the rocket as the law commands them, or hardly: "all canards turn the
/// rocket against the roll command". With such canards no gains hold a roll, and a larger gain drives it faster. Empty:
/// they turn it by the command.
[[nodiscard]] std::string why_uncontrollable(const sim::Scenario& scenario);

}  // namespace fantail::stability
