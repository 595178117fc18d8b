// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "bench/sheet.hpp"

namespace fantail::bench {

/// The plots of one canard: its turn alone, its turn with the others, and its steps in detail. HTML figures.
[[nodiscard]] std::string canard_charts(const CanardResult& result, const Sheet& sheet,
                                        const link::Recording& recording, const Exercise& exercise);

}  // namespace fantail::bench
