// SPDX-License-Identifier: MIT
#pragma once

#include "fantail/command_line.hpp"

namespace fantail::tool {

/// `campaign detection`.
void fill_detection(const Verb& verb);

}  // namespace fantail::tool
