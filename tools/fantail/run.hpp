// SPDX-License-Identifier: MIT
#pragma once

#include "fantail/command_line.hpp"

namespace fantail::tool {

/// The whole of a program `fantail-NAME`, which the program `fantail` starts: reads the command line, does what `fill`
/// has described, says what went wrong, and returns the exit code (exit_code.hpp). The name is one of verb_table.hpp.
[[nodiscard]] int run(const char* name, void (*fill)(const Verb& verb), int argc, char** argv);

}  // namespace fantail::tool
