// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
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

}  // namespace fantail::text
