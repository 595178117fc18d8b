// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace fantail::text {

/// A text as TOML has it, in double quotes.
[[nodiscard]] std::string toml_text(std::string_view text);

}  // namespace fantail::text
