// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fantail/command_line.hpp"
#include "logs/roll_log.hpp"

namespace fantail::tool {

/// How a person's log is to be read: shared by every verb that reads one.
struct LogOptions {
  std::vector<std::string> columns;
  std::string map;  ///< QUANTITY=COLUMN:UNIT,...
  bool save_map = false;
  std::string units = "deg";
  bool truth = false;
};

/// --column.
void add_column_option(const Verb& verb, std::vector<std::string>& columns);
/// --columns: `name` with the dashes. And --save-columns, in the one of a verb's options that has it.
void add_column_map_option(const Verb& verb, const std::string& name, std::string& map);
void add_save_columns_option(const Verb& verb, bool& save_map);
/// --column, --columns, --save-columns, --units and --truth.
void add_log_options(const Verb& verb, LogOptions& options);

/// Empty for OURS=THEIRS.
[[nodiscard]] std::string objection_to_column(const std::string& text);
[[nodiscard]] flight::ColumnNames column_names(const std::vector<std::string>& columns);
/// Throws UsageError for --save-columns without --columns, text::Error as parse_column_map() does.
[[nodiscard]] flight::Reading reading(const LogOptions& options);
/// Throws UsageError for a column that --column has a name for, too.
void apply_typed_map(const std::string& map, const std::string& option, flight::Reading& reading);

/// Writes a map beside the log it was given for; what is kept there already stays for other quantities. Throws
/// UsageError for a log whose columns are Fantail's own.
void save_column_map(const std::string& map, const std::filesystem::path& log, const std::string& option);

}  // namespace fantail::tool
