// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fantail::text {

/// A text as one cell of a table: in quotes where a reader would take it for several, and on one line.
[[nodiscard]] std::string csv_cell(const std::string& text);

/// A word as a shell takes it for one: in quotes where it has to be.
[[nodiscard]] std::string shell_word(const std::string& word);

/// A text as TOML has it, in double quotes. Throws Error (bad_configuration) for one that is not UTF-8: TOML has no way
/// to write such bytes.
[[nodiscard]] std::string toml_text(std::string_view text);

/// Text out of a file as it may stand on a terminal and in JSON: whatever is no printable character in UTF-8 becomes a
/// question mark, and of a text of more than 3000 bytes the middle becomes " ... ".
[[nodiscard]] std::string printable(std::string_view text);

/// Length of the character that a text begins with; 0 when it is none to print.
[[nodiscard]] std::size_t printable_character(std::string_view text);

}  // namespace fantail::text
