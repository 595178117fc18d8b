// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace fantail::text {

/// A text as TOML has it, in double quotes. Throws Error (bad_configuration) for one that is not UTF-8: TOML has no way
/// to write such bytes.
[[nodiscard]] std::string toml_text(std::string_view text);

}  // namespace fantail::text
