// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace fantail::text {

/// The number that all of `text` is, as std::from_chars reads it: no sign but a minus, no spaces, no locale. "inf" and
/// "nan" may be numbers. The nearest double, on every platform; empty for what a double cannot hold.
[[nodiscard]] std::optional<double> decimal(std::string_view text);

}  // namespace fantail::text
