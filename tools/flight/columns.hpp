// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "flight/flight.hpp"

namespace fantail::flight {

/// A column of flight.csv that holds numbers, and its place in a row. Written and read by this one description.
struct Column {
  enum class Unit : std::uint8_t {
    as_named,  ///< the file holds what the row holds: seconds, metres, ...
    degrees,   ///< the row holds radians
    flag,      ///< 0 or 1
  };

  std::string_view name;
  Unit unit;
  bool is_true;                     ///< of the true_ columns, which only a simulated flight has
  double (*get)(const Row& row);    ///< not a number: unknown at this tick
  void (*set)(Row& row, double v);  ///< a true_ column makes Row::truth, where what is not set is not a number

  /// As the file has it: get(), angles in degrees.
  [[nodiscard]] double written(const Row& row) const;
};

/// Word for word and in the order of the file. The column phase, which holds words, is the second of them: it stands
/// behind time_s, which comes first here.
[[nodiscard]] std::span<const Column> columns();
/// Those that flight.csv of this flight has: without the true_ ones where nobody knows a truth, and without the roll
/// that a camera sees where that is not known.
[[nodiscard]] std::span<const Column> columns_of(const Flight& flight);
inline constexpr std::string_view phase_column = "phase";
/// The last column, of flags, where there are rows that were not replayed, and only there.
inline constexpr std::string_view replayed_column = "replayed";

/// Null for a name that is none of these.
[[nodiscard]] const Column* find_column(std::string_view name);

/// A row of which nothing is known but what its type must hold.
[[nodiscard]] Row unknown_row();

/// What a column of a flight holds, for who finds it in a file.
struct ColumnText {
  std::string_view unit;    ///< "deg/s", "m/s2", ...; "-" for what has none: words, flags, numbers of things
  std::string description;  ///< a clause
};

/// Of any column that a flight.csv, a flight log or an export of it can have. Empty for a name that is none of these.
[[nodiscard]] std::optional<ColumnText> column_text(std::string_view name);

/// A number as it stands in every table: "{:.6f}", to the last bit of rounding. Never "-0.000000": two files that
/// differ in nothing else would compare unequal. std::to_chars(fixed, 6) gives the same text, but takes 36 ns a number
/// where this takes 22, and makes a flight.csv of 15 MB in 49 ms where this takes 28 (flights of the shipped scenarios,
/// GCC 12).
class SixDecimals {
 public:
  explicit SixDecimals(double value);

  [[nodiscard]] std::string_view text() const { return {text_.data() + begin_, text_.size() - begin_}; }
  /// Without zeros at the end: "0.25", "7".
  [[nodiscard]] std::string_view brief() const;

 private:
  static constexpr std::size_t longest = 320;  // of a double: 309 digits before the point
  std::array<char, longest> text_;
  std::size_t begin_ = longest;
};

}  // namespace fantail::flight
