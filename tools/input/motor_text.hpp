// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace fantail::input {

/// All that stands in a motor file, in the form of RASP (rasp_file.hpp), as plain text; empty where there is no such
/// file. One of RockSim (.rse) is put into it, motor by motor in its order. Throws text::Error, bad_data for XML that
/// is no engine database.
[[nodiscard]] std::optional<std::string> motor_text(const std::string& file);

}  // namespace fantail::input
