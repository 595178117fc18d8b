// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::flight {

/// A CSV file: a header of names, then rows of cells. Commas; CRLF or LF; a byte-order mark and quoted cells are
/// understood; lines that begin with '#' and lines that hold nothing but commas and spaces are skipped. A cell ends
/// with its line, in quotes too: one stray quote must not swallow the rest of a log.
class Table {
 public:
  /// What messages call a row: its line in the file, or, of a table that was another file's, its number from 1 on.
  enum class Rows : std::uint8_t { by_line, by_number };

  /// `text` is the content, `name` what messages call it. Throws text::Error (bad_data): no header, a name that
  /// stands twice, a row with another number of cells than the header (naming the line), more bytes than of any file.
  /// `first_line`: what messages call the first line of the text.
  [[nodiscard]] static Table parse(std::string text, std::string name, Rows rows = Rows::by_line,
                                   std::size_t first_line = 1);
  /// Throws also as text::read_input() does.
  [[nodiscard]] static Table load(const std::string& path);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return lines_.size(); }
  [[nodiscard]] std::optional<std::size_t> find(std::string_view column) const;
  /// Throws text::Error (bad_data) that names the column and lists those that are there.
  [[nodiscard]] std::size_t column(std::string_view column) const;
  /// Without quotes and without spaces around it.
  [[nodiscard]] std::string_view cell(std::size_t row, std::size_t column) const;
  /// Of a cell; empty unless it is a finite number and nothing else.
  [[nodiscard]] std::optional<double> number(std::size_t row, std::size_t column) const;
  [[nodiscard]] std::size_t line(std::size_t row) const { return lines_[row]; }  ///< counted from 1
  [[nodiscard]] std::size_t header_line() const { return header_line_; }
  /// For messages: "file:7" or "file: row 6".
  [[nodiscard]] std::string where(std::size_t row) const { return at(lines_[row]); }
  /// "line 7" or "row 6".
  [[nodiscard]] std::string place(std::size_t row) const;

 private:
  struct Cell {
    std::uint32_t begin;
    std::uint32_t end;
  };

  Table(std::string text, std::string name, Rows rows)
      : name_{std::move(name)}, text_{std::move(text)}, row_names_{rows} {}
  void read_all(std::size_t first_line);
  void read_header(std::size_t line);
  void read_line(std::size_t begin, std::size_t end, std::size_t line);
  std::size_t read_quoted(std::size_t begin, std::size_t end, std::size_t line);
  [[nodiscard]] std::string_view view(Cell cell) const;
  [[nodiscard]] std::string at(std::size_t line) const;
  [[noreturn]] void refuse(std::size_t line, const std::string& complaint) const;

  std::string name_;
  std::string text_;
  Rows row_names_;
  std::vector<std::string> columns_;
  std::vector<Cell> cells_;  ///< row by row, without the header's
  std::vector<std::size_t> lines_;
  std::size_t header_line_ = 0;
};

/// Its names and cells, a row a line, as parse() reads them.
[[nodiscard]] std::string csv_text(const Table& table);

/// A piece of a file for a message: in quotes, of bearable length, without the characters that move a terminal.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// "no column roll_angle_deg (did you mean roll_deg?); there are: time_s, roll_deg".
[[nodiscard]] std::string missing_column(std::string_view wanted, std::span<const std::string> there);

}  // namespace fantail::flight
