// SPDX-License-Identifier: MIT
#include "text/layout.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace fantail::text {
namespace {

using Row = std::vector<std::string>;

// Blanks between two columns; one alone would be a blank between words.
constexpr std::size_t gap = 2;

std::string joined(const Row& row) {
  std::string line;
  for (const std::string& cell : row) {
    line += cell;
  }
  return line;
}

std::size_t width_of(const std::vector<Row>& rows) {
  std::size_t width = 0;
  for (const Row& row : rows) {
    width = std::max(width, display_width(joined(row)));
  }
  return width;
}

std::size_t blanks_before(const std::string& cell) { return std::min(cell.find_first_not_of(' '), cell.size()); }
std::size_t blanks_behind(const std::string& cell) { return cell.size() - (cell.find_last_not_of(' ') + 1); }

// How many blanks every row has there; a cell of nothing else has as many as one likes.
std::size_t common(const std::vector<Row>& rows, std::size_t column, std::size_t (*blanks)(const std::string&)) {
  std::size_t least = any_width;
  for (const Row& row : rows) {
    // Behind a row's last cell is nothing to stay apart from.
    const bool counts = column + (blanks == blanks_behind ? 1 : 0) < row.size();
    if (counts && blanks(row[column]) < row[column].size()) {
      least = std::min(least, blanks(row[column]));
    }
  }
  return least == any_width ? 0 : least;
}

// Two blanks stay between two columns.
void squeeze(std::vector<Row>& rows, std::size_t columns) {
  for (std::size_t column = 1; column < columns; ++column) {
    const std::size_t behind = common(rows, column - 1, blanks_behind);
    const std::size_t before = common(rows, column, blanks_before);
    const std::size_t surplus = behind + before - std::min(behind + before, gap);
    const std::size_t of_left = std::min(surplus, behind);
    for (Row& row : rows) {
      if (column < row.size()) {
        std::string& left = row[column - 1];
        left.erase(left.size() - std::min(of_left, left.size()));
        row[column].erase(0, std::min(surplus - of_left, row[column].size()));
      }
    }
  }
}

// What stands so far in is a cell below another one already.
constexpr std::size_t deep = 20;

// Where the last cell begins, as a byte; the line's own first word when it has no other.
std::size_t last_cell(std::string_view line) {
  const std::size_t blanks = line.substr(0, line.find_last_not_of(' ') + 1).rfind("  ");
  return blanks == std::string_view::npos ? 0 : blanks + 2;
}

// Nobody copies the pattern of one.
bool is_command(std::string_view text) {
  return text.starts_with("fantail ") && text.find(" [") == std::string_view::npos &&
         text.find("...") == std::string_view::npos;
}

// Words, of which a command is one.
std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const bool is_whole = is_command(text) && (words.empty() || words.back().ends_with(':'));
    const std::size_t end = is_whole ? text.size() : std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

std::size_t width_of(const std::vector<std::string_view>& words) {
  std::size_t width = 0;
  for (const std::string_view word : words) {
    width = std::max(width, display_width(word));
  }
  return width;
}

void append_wrapped(std::string_view line, std::size_t columns, std::string& whole) {
  constexpr std::size_t below = 4;
  const std::size_t own = line.find_first_not_of(' ');
  if (own == std::string_view::npos) {
    return;  // nothing but blanks
  }
  const std::size_t begin = std::max(last_cell(line), own);
  const bool is_comment = line.substr(begin).starts_with("# ");
  const std::vector<std::string_view> words = words_of(line.substr(begin + (is_comment ? 2 : 0)));
  const std::size_t cell = display_width(line.substr(0, begin)) + (is_comment ? 2 : 0);
  const bool is_cell = begin > own || own >= deep;
  // In a few columns words would make a tower, if they fit at all: such a cell goes below as a whole.
  const bool goes_below = is_cell && cell > below && (cell > columns * 5 / 8 || cell + width_of(words) > columns);
  const std::string_view head = line.substr(0, goes_below ? line.find_last_not_of(' ', begin - 1) + 1 : begin);
  const std::string mark = is_comment ? "# " : "";
  if (goes_below && display_width(head) > columns) {
    append_wrapped(head, columns, whole);
  } else {
    whole += head;
  }
  whole += goes_below ? (head.empty() ? "" : "\n") + std::string(below, ' ') + mark : mark;
  const std::size_t indent = goes_below ? below + mark.size() : is_cell ? cell : cell + 2;
  const std::string next = "\n" + std::string(indent - mark.size(), ' ') + mark;
  std::size_t used = goes_below ? indent : cell;
  bool is_behind_a_word = false;
  for (const std::string_view word : words) {
    const std::size_t width = display_width(word);
    if (is_behind_a_word && used + 1 + width > columns) {
      whole += next;
      used = indent;
    } else if (is_behind_a_word) {
      whole += ' ';
      used += 1;
    }
    whole += word;
    used += width;
    is_behind_a_word = true;
  }
}

}  // namespace

void Table::row_to_its_last_word(std::vector<std::string> cells) {
  while (!cells.empty() && blanks_before(cells.back()) == cells.back().size()) {
    cells.pop_back();
  }
  if (!cells.empty()) {
    cells.back().erase(cells.back().find_last_not_of(' ') + 1);
  }
  rows_.push_back(std::move(cells));
}

std::string Table::text(std::size_t width) const {
  std::vector<Row> rows = rows_;
  if (width_of(rows) > width) {
    squeeze(rows, columns_.size());
  }
  std::vector<Column> columns = columns_;
  std::string left_out;
  const auto goes_first = [](const Column& column) { return column.goes_as == 0 ? ~0U : column.goes_as; };
  while (width_of(rows) > width) {
    const auto first = std::ranges::min_element(columns, {}, goes_first);
    if (first == columns.end() || first->goes_as == 0) {
      break;
    }
    const auto index = static_cast<std::size_t>(first - columns.begin());
    left_out += (left_out.empty() ? "" : ", ") + first->name;
    columns.erase(first);
    for (Row& row : rows) {
      if (index < row.size()) {
        row.erase(row.begin() + static_cast<std::ptrdiff_t>(index));
      }
    }
  }
  std::string text;
  for (const Row& row : rows) {
    text += joined(row) + "\n";
  }
  if (!left_out.empty()) {
    text += "  Left out, for the width of this terminal: " + left_out + "\n";
  }
  return text;
}

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
