// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace fantail::text {

/// Of a place that takes lines of any length: a pipe, a file.
inline constexpr std::size_t any_width = std::numeric_limits<std::size_t>::max();

/// The columns that a text takes in a terminal: one for each character of UTF-8, none for a colour (CSI ... m).
[[nodiscard]] std::size_t display_width(std::string_view text);

/// Breaks lines that are wider than `columns` between two words; the others stay as they are. What follows stands below
/// the last cell of the line, where two blanks or more set cells apart; else two columns farther in than the line.
/// After a "# " it begins with one, too. A word that is wider than a line stays whole, and so does a command `fantail
/// ...` that begins a cell or follows a colon: whoever copies a part of it copies another command.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t columns);

}  // namespace fantail::text
