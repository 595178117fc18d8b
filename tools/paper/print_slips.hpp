// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "paper/claim.hpp"

namespace fantail::paper {

/// Signs, units, repeated and contradicting numbers, each with what it must read.
[[nodiscard]] std::vector<Claim> print_slips();

}  // namespace fantail::paper
