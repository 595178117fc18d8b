// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace fantail::text {

/// A word as a shell takes it for one: in quotes where it has to be.
[[nodiscard]] std::string shell_word(const std::string& word);

}  // namespace fantail::text
