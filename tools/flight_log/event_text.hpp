// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "protocol/log_notes.hpp"

namespace fantail::flight_log {

/// "Controlling: guide clear and fast enough", "canard 2 stalled".
[[nodiscard]] std::string event_text(const protocol::LogEvent& event);

}  // namespace fantail::flight_log
