// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace fantail::input {

// How messages for a person put things.

/// What a person wrote: the shortest decimal that is this value, so that a number just beyond a limit does not look
/// like the limit.
[[nodiscard]] std::string plain_number(double value);

/// What was calculated, to six digits.
[[nodiscard]] std::string about(double value);

/// The one of `known` that a person most likely meant; empty when none is near.
[[nodiscard]] std::optional<std::string> suggestion(std::string_view wrong, std::span<const std::string> known);

}  // namespace fantail::input
