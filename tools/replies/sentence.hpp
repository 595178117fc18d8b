// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "hal/can_bus.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::replies {

// The one-word answers of the avionics, as sentences for the person who has to act on them.

[[nodiscard]] std::string sentence(protocol::SessionReason reason);
[[nodiscard]] std::string sentence(protocol::SelfTestFailure failure, const std::optional<std::size_t>& canard);
[[nodiscard]] std::string sentence(protocol::ArmRefusal refusal);
[[nodiscard]] std::string sentence(protocol::LogFault fault);
/// Names the refused field of the plan where there is one.
[[nodiscard]] std::string sentence(const protocol::PlanReply& reply);

/// "ready", "asks to abort", ...
[[nodiscard]] std::string_view sentence(protocol::AbortState state);

/// "none_fitted", "asks_to_abort", ...
[[nodiscard]] std::string_view name(protocol::AbortState state);
/// "built_in", "stored_is_broken", ...
[[nodiscard]] std::string_view name(protocol::PlanSource source);
/// "error active", "bus off", ...
[[nodiscard]] std::string_view name(hal::CanState state);

}  // namespace fantail::replies
