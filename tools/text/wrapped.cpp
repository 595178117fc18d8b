// SPDX-License-Identifier: MIT
#include "text/wrapped.hpp"

#include <algorithm>
#include <vector>

namespace fantail::text {
namespace {

// What stands so far in is a cell below another one already.
constexpr std::size_t deep = 20;

// Where the last cell begins, as a byte; the line's own first word when it has no other.
std::size_t last_cell(std::string_view line) {
  const std::size_t blanks = line.substr(0, line.find_last_not_of(' ') + 1).rfind("  ");
  return blanks == std::string_view::npos ? 0 : blanks + 2;
}

// Words, of which a command is one.
std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const bool is_command = text.starts_with("fantail ") && (words.empty() || words.back().ends_with(':'));
    const std::size_t end = is_command ? text.size() : std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

void append_wrapped(std::string_view line, std::size_t columns, std::string& whole) {
  const std::size_t own = line.find_first_not_of(' ');
  if (own == std::string_view::npos) {
    return;  // nothing but blanks
  }
  const std::size_t begin = std::max(last_cell(line), own);
  const std::size_t cell = display_width(line.substr(0, begin));
  // In a few columns words would make a tower: such a cell goes below as a whole.
  const bool is_narrow = cell > columns * 5 / 8;
  const std::size_t indent = begin == own && own < deep ? own + 2 : cell;
  std::string next{'\n'};
  next.append(is_narrow ? 4 : indent, ' ').append(line.substr(begin).starts_with("# ") ? "# " : "");
  const bool goes_below = is_narrow && begin > own;
  const std::string_view head = line.substr(0, goes_below ? line.find_last_not_of(' ', begin - 1) + 1 : begin);
  whole += head;
  std::size_t used = display_width(head);
  bool breaks = goes_below;
  bool is_behind_a_word = false;
  for (const std::string_view word : words_of(line.substr(begin))) {
    const std::size_t width = display_width(word);
    if (breaks || (is_behind_a_word && used + 1 + width > columns)) {
      whole += next;
      used = next.size() - 1;
    } else if (is_behind_a_word) {
      whole += ' ';
      used += 1;
    }
    whole += word;
    used += width;
    is_behind_a_word = true;
    breaks = false;
  }
}

}  // namespace

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  bool in_colour = false;
  for (const char c : text) {
    if (c == '\033') {
      in_colour = true;
    } else if (in_colour) {
      in_colour = c != 'm';
    } else {
      width += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;  // not the rest of a character
    }
  }
  return width;
}

std::string wrapped(std::string_view text, std::size_t columns) {
  std::string whole;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (display_width(line) <= columns) {
      whole += line;
    } else {
      append_wrapped(line, columns, whole);
    }
    whole += end < text.size() ? "\n" : "";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return whole;
}

}  // namespace fantail::text
