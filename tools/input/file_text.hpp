// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace fantail::input {

/// All that stands in a file; empty where there is no such file. Documents and motors are read by this alone, so that a
/// program without files can have another. Throws as text::read_input() does for one that a person writes.
[[nodiscard]] std::optional<std::string> file_text(const std::string& file);

}  // namespace fantail::input
