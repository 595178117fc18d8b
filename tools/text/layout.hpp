// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fantail::text {

/// Rows of cells, each padded by whoever fills it. Where there is room its text is the cells behind each other, no
/// more; in a narrower place blanks that no row needs go first, then columns, and a last line says which.
class Table {
 public:
  struct Column {
    std::string name;      ///< as the line about columns that are left out calls it
    unsigned goes_as = 0;  ///< the first to go is 1; 0 stays
  };
  explicit Table(std::vector<Column> columns) : columns_{std::move(columns)} {}

  /// Fewer cells than columns are a row that ends early.
  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  /// The same without blanks at its end.
  void row_to_its_last_word(std::vector<std::string> cells);

  /// Every line ends with a newline.
  [[nodiscard]] std::string text(std::size_t width) const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Of a place that takes lines of any length: a pipe, a file.
inline constexpr std::size_t any_width = std::numeric_limits<std::size_t>::max();

/// The columns that a text takes in a terminal: one for each character of UTF-8, none for a colour (CSI ... m).
[[nodiscard]] std::size_t display_width(std::string_view text);

/// Breaks lines that are wider than `columns` between two words; the others stay as they are. What follows stands below
/// the last cell of the line, where two blanks or more set cells apart; else two columns farther in than the line. A
/// cell that is too narrow for its words goes to a line of its own, four columns in. After a "# " every line begins
/// with one, too. A word that is wider than a line stays whole, and so does a command `fantail fly ...` that begins a
/// cell or follows a colon: whoever copies a part of it copies another command.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t columns);

}  // namespace fantail::text
