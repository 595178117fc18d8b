// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "flight/table.hpp"

namespace fantail::files {

/// A table in which every few columns have a column of time of their own in front ("Time@Axial Accel (Gs)", or "time"
/// again and again), as one table with the column "time", sorted by it: a row has what was read at its time, and its
/// other cells are empty. Empty: it is no such table.
[[nodiscard]] std::optional<std::string> in_one_clock(const flight::Table& table);

}  // namespace fantail::files
