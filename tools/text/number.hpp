// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace fantail::text {

/// `text` without spaces and tabs at its ends, and without carriage returns at its end.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The finite number that `text` is, spaces around it allowed; empty for anything else, "nan" and "1,5" too.
[[nodiscard]] std::optional<double> number(std::string_view text);

}  // namespace fantail::text
