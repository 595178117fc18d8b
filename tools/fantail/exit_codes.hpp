// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "fantail/run.hpp"
#include "manual/command.hpp"

namespace fantail::tool {

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
};

}  // namespace fantail::tool
