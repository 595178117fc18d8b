// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace fantail::tool {

/// Writes what a person is watching to standard output, at once. False: there is no use in going on. A reader that has
/// left has seen enough; that is no fault, and a full disk is one, which the end of the program will say.
[[nodiscard]] bool shown(const std::string& text);

}  // namespace fantail::tool
