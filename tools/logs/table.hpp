// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::logs {

/// A CSV file: a header of names, then rows of cells. Commas; CRLF or LF; a byte-order mark and quoted cells are
/// understood; lines that begin with '#' and empty lines are skipped.
class Table {
 public:
  /// `text` is the content, `name` what messages call it. Throws sim::InputError (bad_data): no header, a name that
  /// stands twice, a row with another number of cells than the header (naming the line), more than `most_bytes`.
  [[nodiscard]] static Table parse(std::string_view text, std::string name);
  /// Throws also no_such_input.
  [[nodiscard]] static Table load(const std::string& path);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return lines_.size(); }
  [[nodiscard]] std::optional<std::size_t> find(std::string_view column) const;
  /// Throws sim::InputError (bad_data) that names the column and lists those that are there.
  [[nodiscard]] std::size_t column(std::string_view column) const;
  [[nodiscard]] std::string_view cell(std::size_t row, std::size_t column) const;
  /// Of a cell; empty unless it is a finite number and nothing else.
  [[nodiscard]] std::optional<double> number(std::size_t row, std::size_t column) const;
  [[nodiscard]] std::size_t line(std::size_t row) const { return lines_[row]; }  ///< counted from 1

 private:
  std::string name_;
  std::string text_;
  std::vector<std::string> columns_;
  std::vector<std::size_t> lines_;
};

}  // namespace fantail::logs
