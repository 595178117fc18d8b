// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <span>
#include <string>

#include "manual/command.hpp"
#include "manual/roff.hpp"

namespace fantail::manual {

/// The manual page of a command, its own commands included, up to SEE ALSO.
[[nodiscard]] std::string command_page(const Command& command, const Title& title, std::span<const ExitCode> codes);

/// "fantail(1)"
[[nodiscard]] std::string see_also(std::initializer_list<const char*> pages);

}  // namespace fantail::manual
