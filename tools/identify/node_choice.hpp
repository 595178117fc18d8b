// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "identify/identification.hpp"
#include "identify/record.hpp"
#include "logs/roll_log.hpp"

namespace fantail::identify {

/// Reads "0,5" (seconds from the begin of the record), "even:N" (N intervals), "thrust:N,coast:M" (N even intervals
/// until burn-out, M behind it) or "auto". Throws sim::InputError: bad_configuration for anything else; bad_data when
/// burn-out does not lie inside the record, or the log does not know it.
[[nodiscard]] NodeChoice find_nodes(const logs::RollLog& log, const Record& record, const std::string& text);

}  // namespace fantail::identify
