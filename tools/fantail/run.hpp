// SPDX-License-Identifier: MIT
#pragma once

#include <exception>

#include "fantail/command_line.hpp"

namespace fantail::tool {

/// Is this error one of a verb's own: a bus, a network, a flight computer that is not there? Its exit code is that of
/// input and output.
using IsInputOutput = bool (*)(const std::exception& error);

template <typename... Errors>
bool is_one_of(const std::exception& error) {
  return ((dynamic_cast<const Errors*>(&error) != nullptr) || ...);
}

/// The whole of a program `fantail-NAME`, which the program `fantail` starts: reads the command line, does what `fill`
/// has described, says what went wrong, and returns the exit code (exit_code.hpp). The name is one of verb_table.hpp.
[[nodiscard]] int run(const char* name, void (*fill)(const Verb& verb), int argc, char** argv,
                      IsInputOutput is_input_output = is_one_of<>);

}  // namespace fantail::tool
