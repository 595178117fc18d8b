// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace fantail::text {

/// A text as one cell of a table: in quotes where a reader would take it for several, and on one line.
[[nodiscard]] std::string csv_cell(const std::string& text);

}  // namespace fantail::text
