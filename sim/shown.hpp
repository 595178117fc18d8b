// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace fantail::sim {

// Numbers in messages.

/// What a person wrote: the shortest decimal that is this value, so that a number just beyond a limit does not look
/// like the limit.
[[nodiscard]] std::string shown(double value);

/// What was calculated, to six digits.
[[nodiscard]] std::string about(double value);

}  // namespace fantail::sim
