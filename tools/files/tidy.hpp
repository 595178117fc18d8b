// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fantail::files {

/// A table as flight::Table reads it.
struct Tidied {
  std::string text;                  ///< each row is on its line
  std::size_t first_line = 1;        ///< its number in the file; 0: a line of names was put in front
  std::vector<std::string> notes{};  ///< what was done, a sentence each where a person may not expect it
};

/// Of the bytes of a table that another program has written: in UTF-8 or UTF-16; cells that are separated by commas,
/// semicolons or tabs, as the rows or a line "sep=;" say; numbers with a decimal comma where another sign separates,
/// or with commas between thousands; lines about the logger ahead of the names, and names behind a '#'; names that
/// come again, which become NAME.1, NAME.2; no names at all, which become #1, #2; rows with fewer cells than names,
/// of which the rest is empty, and a last line that is cut off, which is left out.
///
/// A table that is Fantail's own, by the column time_s in its first line, is only put into UTF-8.
[[nodiscard]] Tidied tidied(std::string bytes);

}  // namespace fantail::files
