// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fantail/command_line.hpp"
#include "logs/roll_log.hpp"

namespace fantail::tool {

/// How a person's log is to be read: shared by every verb that reads one.
struct LogOptions {
  std::vector<std::string> columns;
  std::string units = "deg";
  bool truth = false;
};

/// --column.
void add_column_option(const Verb& verb, std::vector<std::string>& columns);
/// --column, --units and --truth.
void add_log_options(const Verb& verb, LogOptions& options);

/// Empty for OURS=THEIRS.
[[nodiscard]] std::string objection_to_column(const std::string& text);
[[nodiscard]] flight::ColumnNames column_names(const std::vector<std::string>& columns);
[[nodiscard]] flight::Reading reading(const LogOptions& options);

}  // namespace fantail::tool
