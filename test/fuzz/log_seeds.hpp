// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace fantail::test {

/// What the fuzzing of the log reader begins with: short logs of every kind, each with the byte before it that has its
/// frames sealed.
[[nodiscard]] std::vector<std::string> log_seeds();

}  // namespace fantail::test
