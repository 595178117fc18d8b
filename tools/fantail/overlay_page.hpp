// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fantail/compare_results.hpp"
#include "logs/roll_log.hpp"

namespace fantail::tool {

/// One page with two flights on A's clock: roll angle and rate with their differences, command, canards and speed, as
/// far as both logs have them.
[[nodiscard]] std::string overlay_html(const CompareResults& results, const logs::RollLog& a, const logs::RollLog& b);

}  // namespace fantail::tool
