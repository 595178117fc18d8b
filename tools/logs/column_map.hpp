// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "flight/read_csv.hpp"

namespace fantail::logs {

/// Which column of another logger's file is what, and in which unit.
struct MappedColumn {
  std::string ours;    ///< of flight.csv: roll_rate_deg_s
  std::string theirs;  ///< the name in the file: p
  std::string unit;    ///< of theirs: rad/s; empty for words and flags
};
using ColumnMap = std::vector<MappedColumn>;

/// "time=t:ms,roll_rate=p:rad/s,phase=mode": what Fantail calls a column without its unit, the name in the file and its
/// unit. `option` is named in messages. Throws text::Error (bad_configuration) for a quantity or a unit that Fantail
/// does not know, a unit that is missing or of another dimension (naming those allowed), or a quantity twice.
[[nodiscard]] ColumnMap parse_column_map(std::string_view text, const std::string& option);

/// The same, kept beside a log: table columns, roll_rate = "p:rad/s". Throws as parse_column_map() does, with file and
/// line, and text::Error (bad_data) for a file that is not TOML.
[[nodiscard]] ColumnMap read_column_map(const std::filesystem::path& file);
[[nodiscard]] std::string column_map_toml(const ColumnMap& map, const std::string& log);

/// LOG.columns.toml.
[[nodiscard]] std::filesystem::path column_map_file(const std::filesystem::path& log);

/// What both say, and where they disagree the first.
[[nodiscard]] ColumnMap merged(const ColumnMap& first, const ColumnMap& second);

/// "time is t in ms, roll_rate is p in rad/s".
[[nodiscard]] std::string column_map_words(const ColumnMap& map);

/// Makes a reading follow a map, except for columns that the reading has another name for already.
void apply_map(const ColumnMap& map, flight::Reading& reading);

/// Applies the map that lies beside a log, if there is one. Returns a sentence that says so, or nothing.
[[nodiscard]] std::string apply_map_beside(const std::filesystem::path& log, flight::Reading& reading);

}  // namespace fantail::logs
