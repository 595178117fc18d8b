// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "protocol/log_notes.hpp"

namespace fantail::log_export {

/// The words for an event's value and detail; empty where its kind has none.
[[nodiscard]] std::string_view value_word(const protocol::LogEvent& event);
[[nodiscard]] std::string_view detail_word(const protocol::LogEvent& event);

/// "phase: controlling (guide_clear)", "canard_verdict: canard 3 stalled".
[[nodiscard]] std::string sentence(const protocol::LogEvent& event);

}  // namespace fantail::log_export
