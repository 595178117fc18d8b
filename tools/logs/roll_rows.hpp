// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "logs/roll_columns.hpp"
#include "logs/roll_log.hpp"
#include "logs/table.hpp"

namespace fantail::logs {

/// Fills the lists of a log as they stand in the file, angles in the file's unit, and its counts of rows. `columns`
/// begin with time_s. Throws sim::InputError as read_roll_log does.
void read_roll_rows(const Table& table, std::span<const FoundColumn> columns, std::optional<std::size_t> phase,
                    RollLog& log);

}  // namespace fantail::logs
