// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "protocol/log_notes.hpp"

namespace fantail::flight_log {

/// "Controlling: guide clear and fast enough", "canard 2 stalled". `log_begins`: Flight::first_time of its log.
[[nodiscard]] std::string event_text(const protocol::LogEvent& event, core::Microseconds log_begins);

}  // namespace fantail::flight_log
