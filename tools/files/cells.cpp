// SPDX-License-Identifier: MIT
#include "files/cells.hpp"

#include "text/number.hpp"

namespace fantail::files {

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    quoted = line[i] == '"' ? !quoted : quoted;
    if (line[i] == separator && !quoted) {
      cells.push_back(line.substr(begin, i - begin));
      begin = i + 1;
    }
  }
  cells.push_back(line.substr(begin));
  return cells;
}

std::string_view unquoted(std::string_view cell) {
  cell = text::trimmed(cell);
  const bool has_quotes = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return has_quotes ? text::trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

bool looks_like_number(std::string_view cell) {
  constexpr std::string_view of_numbers = "0123456789.,+-eE";
  cell = unquoted(cell);
  return !cell.empty() && cell.find_first_not_of(of_numbers) == std::string_view::npos &&
         cell.find_first_of("0123456789") != std::string_view::npos;
}

bool looks_like_time(std::string_view cell) {
  cell = unquoted(cell);
  return cell.find(':') != std::string_view::npos &&
         cell.find_first_not_of("0123456789.,:-/ TZ+") == std::string_view::npos &&
         cell.find_first_of("0123456789") != std::string_view::npos;
}

bool is_row(std::string_view line, char separator) {
  if (line.empty() || is_comment(line)) {
    return false;
  }
  int numbers = 0;
  int words = 0;
  for (const std::string_view cell : cells_of(line, separator)) {
    if (!unquoted(cell).empty()) {
      ++(looks_like_number(cell) || looks_like_time(cell) ? numbers : words);
    }
  }
  return numbers > 0 && numbers >= words;
}

}  // namespace fantail::files
