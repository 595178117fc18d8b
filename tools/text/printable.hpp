// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fantail::text {

/// Text out of a file as it may stand on a terminal and in JSON: whatever is no printable character in UTF-8 becomes a
/// question mark, and of a text of more than 3000 bytes the middle becomes " ... ".
[[nodiscard]] std::string printable(std::string_view text);

/// Length of the character that a text begins with; 0 when it is none to print.
[[nodiscard]] std::size_t printable_character(std::string_view text);

}  // namespace fantail::text
