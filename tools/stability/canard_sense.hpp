// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sim/scenario.hpp"

namespace fantail::stability {

/// A clause on canards that together do not turn the rocket as the law commands them, or hardly: "all canards turn the
/// rocket against the roll command". With such canards no gains hold a roll, and a larger gain drives it faster. Empty:
/// they turn it by the command.
[[nodiscard]] std::string why_uncontrollable(const sim::Scenario& scenario);

/// What is left in the end of a roll torque of all canards: the fins take a part of it back, and canards whose
/// direction differs between plan and vehicle another. Zero or less: why_uncontrollable().
[[nodiscard]] double left_in_the_end(const sim::Scenario& scenario);

/// A clause on one canard that the others outweigh; empty: there is none.
[[nodiscard]] std::string works_against(const sim::Scenario& scenario);

}  // namespace fantail::stability
