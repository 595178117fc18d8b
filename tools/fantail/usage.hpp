// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace fantail::tool {

/// One line on what is wrong with a command line, naming the word that is.
[[nodiscard]] std::string usage_complaint(const CLI::App& program, const CLI::ParseError& error);

}  // namespace fantail::tool
