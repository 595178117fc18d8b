// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "manual/command.hpp"

namespace fantail::manual {

/// What may stand in place of the last of the words that have been typed behind the command's name; it may be empty.
/// The first line says what else may: "words" (nothing else), "files" or "folders". Then a line for each word that
/// begins so, where its meaning is known with a tab and that behind it.
[[nodiscard]] std::string completion(const Command& command, std::span<const std::string> words);

}  // namespace fantail::manual
