// SPDX-License-Identifier: MIT
#pragma once

#include "fantail/command_line.hpp"

namespace fantail::tool {

// What fantail log can do, each in its own file.

void add_log_export(const Verb& log);
void add_log_info(const Verb& log);

}  // namespace fantail::tool
