// SPDX-License-Identifier: MIT
#include "text/table.hpp"

#include <algorithm>
#include <utility>

#include "text/wrapped.hpp"

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

}  // namespace fantail::text
