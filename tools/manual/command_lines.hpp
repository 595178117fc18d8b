// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fantail::manual {

/// A command as lines that a shell takes as one: broken before options, or where that is not enough between words; each
/// but the last ends with a backslash, and each but the first is four columns further in. What is quoted stays
/// together, however long it is.
[[nodiscard]] std::string command_lines(std::string_view command, std::string_view indent, std::size_t columns);

}  // namespace fantail::manual
