// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fantail::files {

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

}  // namespace fantail::files
