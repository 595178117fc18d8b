// SPDX-License-Identifier: MIT
#pragma once

#include "fantail/command_line.hpp"

namespace fantail::tool {

/// `campaign faults`.
void fill_faults(const Verb& verb);

}  // namespace fantail::tool
