// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "manual/command.hpp"

namespace fantail::tool {

/// fantail(1): what the program says of itself, and what holds for every verb.
[[nodiscard]] std::string program_page(const manual::Command& program, const std::string& date);

}  // namespace fantail::tool
