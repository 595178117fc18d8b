// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flight/table.hpp"

namespace fantail::trajectory {

/// The table in a CSV file as RocketPy and OpenRocket export it. Their header is a comment, the last one with a cell
/// "Time" before the first row; an ordinary header will do too. Cells are separated by commas, semicolons or tabs; the
/// decimal point is a point. `text` is the content, `name` what messages call it.
///
/// Throws text::Error (bad_data) as flight::Table does, for a semicolon or tab beside commas, and for what RocketPy
/// exports when no variable is named: its header then lacks three columns, and nobody knows which number is which.
[[nodiscard]] flight::Table exported_table(std::string text, const std::string& name);

}  // namespace fantail::trajectory
