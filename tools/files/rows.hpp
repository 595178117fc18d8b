// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "files/sources.hpp"
#include "flight/table.hpp"

/// Which rows of a table count: the one place where times that repeat or go back, and cells that hold no number, are
/// dealt with. No number are: an empty cell, words, the largest and smallest whole numbers of 32 bits, and -999, -9999
/// and so on in a column whose other numbers are all smaller by a third at least. A time may also be that of a clock or
/// calendar (clock_time_s), which counts from the first row on, and a counter of 16, 24 or 32 bits that begins again.
namespace fantail::files {

/// A column of a table that is read. The numbers become cell * factor + offset.
struct Found {
  std::size_t column = 0;
  double factor = 1.0;
  double offset = 0.0;
  std::optional<double> no_value{};                         ///< what the file has where there is no number
  bool needed = false;                                      ///< a row without its number does not count
  bool is_flag = false;                                     ///< 1, true, yes, ...: it becomes 1 or 0
  double least = -std::numeric_limits<double>::infinity();  ///< of what it becomes; beyond it the file is refused
  double most = std::numeric_limits<double>::infinity();
};

/// The column that `sources` name for a quantity, else Fantail's own. Throws text::Error (bad_data) for one that is not
/// there, naming those that are and, where `option` is not empty, how another is named: "--columns".
[[nodiscard]] Found find_column(const flight::Table& table, const Sources& sources, Quantity quantity,
                                const std::string& option);

/// Of rows with one time ...
enum class SameTime : std::uint8_t {
  identical,      ///< nobody knows which is right: only identical ones are taken, and count as one
  first_counts,   ///< a simulator writes the row of an event twice
  last_of_a_cell  ///< a logger writes a row again when another sensor has news: of each column the last number counts
};

struct Rule {
  SameTime same_time = SameTime::identical;
  double same_within_s = 0.0;
  double most_left_out = 0.01;              ///< share of rows that lack a needed number
  std::optional<std::size_t> only_where{};  ///< a column of flags: rows in which it says no do not count
};

struct Rows {
  std::vector<std::size_t> rows;            ///< of the table, in their order; time increases
  std::vector<std::vector<double>> values;  ///< of each column that was asked for; not a number: not known
  /// Cells of each column without a number, in rows whose needed columns have theirs.
  struct Lost {
    std::size_t empty = 0;
    std::size_t words = 0;
    std::size_t first_row = 0;
  };
  std::vector<Lost> lost;
  std::size_t read = 0;            ///< rows that count, those with the time of another, too
  std::size_t not_used = 0;        ///< by Rule::only_where
  std::vector<std::string> notes;  ///< what was left out, a sentence each
};

/// The first column is the time, which must be needed. Throws text::Error (bad_data), naming file and line: time that
/// goes back, two different rows with one time where they must be identical, a number out of its range, more rows
/// without a needed number than the rule allows.
[[nodiscard]] Rows read_rows(const flight::Table& table, std::span<const Found> columns, const Rule& rule);

}  // namespace fantail::files
