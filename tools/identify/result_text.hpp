// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "identify/study.hpp"

namespace fantail::identify {

/// For a terminal: one table a window, its methods side by side, and what the numbers are worth in words.
[[nodiscard]] std::string result_text(const Study& study);

}  // namespace fantail::identify
