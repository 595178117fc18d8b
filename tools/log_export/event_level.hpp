// SPDX-License-Identifier: MIT
#pragma once

#include "protocol/log_notes.hpp"

namespace fantail::log_export {

/// Something that a person should look at; other events are news.
[[nodiscard]] inline bool is_warning(const protocol::LogEvent& event) {
  switch (event.kind) {
    case protocol::LogEventKind::records_dropped: return true;
    case protocol::LogEventKind::canard_verdict:
    case protocol::LogEventKind::gyro_state:
    case protocol::LogEventKind::accelerometer_state: return event.value != 0;
    default: return false;
  }
}

}  // namespace fantail::log_export
