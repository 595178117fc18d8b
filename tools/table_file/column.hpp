// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fantail::table_file {

/// What other programs are to take a column for.
enum class Kind : std::uint8_t { number, integer, flag, word };

/// One column of a table. All columns of one are equally long.
struct Column {
  std::string name;
  Kind kind = Kind::number;
  /// Not a number: unknown. Of a flag 0 or 1; of a word its place in `words`, counted from 0.
  std::vector<double> values{};
  std::vector<std::string> words{};  ///< those that occur

  friend bool operator==(const Column&, const Column&) = default;
};
using Columns = std::vector<Column>;

/// More than this is hardly one flight, and what unpacks to more is a bomb.
inline constexpr std::size_t most_bytes = std::size_t{1} << 29U;

}  // namespace fantail::table_file
