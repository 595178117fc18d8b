// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fantail::flight {

/// What a column of a flight holds, for who finds it in a file.
struct ColumnText {
  std::string_view unit;    ///< "deg/s", "m/s2", ...; "-" for what has none: words, flags, numbers of things
  std::string description;  ///< a clause
};

/// Of any column that a flight.csv, a flight log or an export of it can have. Empty for a name that is none of these.
[[nodiscard]] std::optional<ColumnText> column_text(std::string_view name);

}  // namespace fantail::flight
