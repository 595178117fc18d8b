// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "hal/can_bus.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::link {

// What the avionics answers with one word, as a sentence for whoever has to do something about it.

[[nodiscard]] std::string words(protocol::SessionReason reason);
[[nodiscard]] std::string words(protocol::SelfTestFailure failure, const std::optional<std::size_t>& canard);
[[nodiscard]] std::string words(protocol::ArmRefusal refusal);
[[nodiscard]] std::string words(protocol::LogFault fault);
/// Names the refused field of the plan where there is one.
[[nodiscard]] std::string words(const protocol::PlanReply& reply);

/// "error active", "bus off", ...
[[nodiscard]] std::string_view words(hal::CanState state);

}  // namespace fantail::link
