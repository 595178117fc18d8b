// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "fantail/run.hpp"
#include "manual/command.hpp"

namespace fantail::tool {

/// The examples of a verb's help as they are where all of their lines fit. In a narrower place each command stands
/// above its meaning, and goes on after a backslash, so that a shell takes what is copied.
[[nodiscard]] std::string examples_text(std::string_view text, std::size_t columns);

/// What each exit code says, for help and manual.
inline constexpr std::array exit_codes{
    manual::ExitCode{static_cast<int>(ExitCode::done), "done"},
    manual::ExitCode{static_cast<int>(ExitCode::requirement_not_met), "a requirement was not met"},
    manual::ExitCode{static_cast<int>(ExitCode::usage), "usage"},
    manual::ExitCode{static_cast<int>(ExitCode::bad_data), "bad data"},
    manual::ExitCode{static_cast<int>(ExitCode::no_such_input), "no such input"},
    manual::ExitCode{static_cast<int>(ExitCode::not_installed), "not installed"},
    manual::ExitCode{static_cast<int>(ExitCode::internal_error), "internal error"},
    manual::ExitCode{static_cast<int>(ExitCode::input_output), "input/output"},
    manual::ExitCode{static_cast<int>(ExitCode::bad_configuration), "bad configuration"},
    manual::ExitCode{static_cast<int>(ExitCode::interrupted), "interrupted"},
    manual::ExitCode{static_cast<int>(ExitCode::pipe_closed), "output pipe closed"},
};

/// fantail(1): what the program says of itself, and what holds for every verb.
[[nodiscard]] std::string program_page(const manual::Command& program, const std::string& date);

}  // namespace fantail::tool
