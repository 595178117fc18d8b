// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace fantail::files {

/// What a file is by its first bytes, and how its numbers become a table, as the end of a sentence: "an ArduPilot
/// DataFlash log; ...". Empty for what may be a table.
[[nodiscard]] std::string kind_that_is_no_table(std::string_view bytes);

}  // namespace fantail::files
