// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
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

}  // namespace fantail::flight
