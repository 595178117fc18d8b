// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace fantail::tool {

// What fantail log can do, each in its own file.

void add_log_export(CLI::App& log);
void add_log_info(CLI::App& log);

}  // namespace fantail::tool
