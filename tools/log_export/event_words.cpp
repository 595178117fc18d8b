// SPDX-License-Identifier: MIT
#include "log_export/event_words.hpp"

#include <fmt/core.h>

#include "core/tick_record.hpp"

namespace fantail::log_export {

using protocol::LogEventKind;

std::string_view value_word(const protocol::LogEvent& event) {
  switch (event.kind) {
    case LogEventKind::recording_ended: return name(static_cast<protocol::LogEnd>(event.value));
    case LogEventKind::phase: return name(static_cast<core::Phase>(event.value));
    case LogEventKind::canard_verdict: return name(static_cast<core::CanardVerdict>(event.value));
    case LogEventKind::gyro_state:
    case LogEventKind::accelerometer_state: return name(static_cast<core::SensorState>(event.value));
    case LogEventKind::command_status: return name(static_cast<core::CommandStatus>(event.value));
    case LogEventKind::recording_began:
    case LogEventKind::records_dropped: break;
  }
  return {};
}

std::string_view detail_word(const protocol::LogEvent& event) {
  return event.kind == LogEventKind::phase ? name(static_cast<core::PhaseReason>(event.detail)) : std::string_view{};
}

std::string sentence(const protocol::LogEvent& event) {
  const std::string_view kind = name(event.kind);
  switch (event.kind) {
    case LogEventKind::recording_began: return fmt::format("{}: flight {}", kind, event.number);
    case LogEventKind::records_dropped: return fmt::format("{}: {} ticks", kind, event.number);
    case LogEventKind::phase: return fmt::format("{}: {} ({})", kind, value_word(event), detail_word(event));
    case LogEventKind::canard_verdict: return fmt::format("{}: canard {} {}", kind, event.index + 1, value_word(event));
    default: return fmt::format("{}: {}", kind, value_word(event));
  }
}

}  // namespace fantail::log_export
