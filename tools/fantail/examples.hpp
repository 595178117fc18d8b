// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fantail::tool {

/// The examples of a verb's help as they are where all of their lines fit. In a narrower place each command stands
/// above its meaning, and goes on after a backslash, so that a shell takes what is copied.
[[nodiscard]] std::string examples_text(std::string_view text, std::size_t columns);

}  // namespace fantail::tool
