// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

// The cells of one line of a table that another program has written.
namespace fantail::files {

/// In their order, with their quotes and spaces; a separator within quotes is none.
[[nodiscard]] std::vector<std::string_view> cells_of(std::string_view line, char separator);
/// Without quotes, and without the spaces around and within them.
[[nodiscard]] std::string_view unquoted(std::string_view cell);
[[nodiscard]] bool looks_like_number(std::string_view cell);
/// As clocks write times and dates.
[[nodiscard]] bool looks_like_time(std::string_view cell);
[[nodiscard]] inline bool is_comment(std::string_view line) { return line.starts_with('#'); }
/// At least half of what stands in it is numbers.
[[nodiscard]] bool is_row(std::string_view line, char separator);

}  // namespace fantail::files
