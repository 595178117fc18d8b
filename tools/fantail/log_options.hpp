// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "fantail/command_line.hpp"
#include "logs/roll_log.hpp"

namespace fantail::tool {

/// Which column of a file is what, as typed.
struct ColumnOptions {
  std::string said;                ///< --columns: rad or deg, and QUANTITY=COLUMN:UNIT,...
  std::vector<std::string> names;  ///< the older --column OURS=THEIRS
  std::string units = "deg";       ///< the older --units
};

/// `dashes` and "columns": "--a-". And the older spellings, which mean the same: -column, and -units.
void add_columns_option(const Verb& verb, const std::string& dashes, ColumnOptions& columns);
/// The same, without units of angles, for a tunnel's log, which has none.
void add_tunnel_columns_option(const Verb& verb, ColumnOptions& columns);
void add_save_columns_option(const Verb& verb, bool& save);

/// Throws UsageError for a column that both spellings name, text::Error as files::parse_columns() does.
[[nodiscard]] files::Sources sources(const ColumnOptions& columns, const std::string& dashes,
                                     std::span<const files::Quantity> asked);
[[nodiscard]] logs::Reading reading(const ColumnOptions& columns, const std::string& dashes, bool truth);

/// Keeps what was said beside the log it was given for; what is kept there already stays for other quantities. Throws
/// UsageError for a log whose columns are Fantail's own.
void save_columns(const ColumnOptions& columns, const std::filesystem::path& log, const std::string& dashes);

/// How a person's log is to be read: shared by every verb that reads one.
struct LogOptions {
  ColumnOptions columns;
  bool save_columns = false;
  bool truth = false;
};

/// --columns, --save-columns and --truth.
void add_log_options(const Verb& verb, LogOptions& options);
/// Throws UsageError for --save-columns without --columns, and as sources() does.
[[nodiscard]] logs::Reading reading(const LogOptions& options);
/// Does what --save-columns asks for, if it does.
void save_columns(const LogOptions& options, const std::filesystem::path& log);

}  // namespace fantail::tool
