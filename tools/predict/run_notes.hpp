// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "predict/run.hpp"

namespace fantail::predict {

/// What the flights of the runs remark, each sentence once, with in how many of them. Sentences that differ in their
/// figures only count as one; it has the figures of the first run.
[[nodiscard]] std::vector<std::string> notes_of(const std::vector<Run>& runs);

}  // namespace fantail::predict
