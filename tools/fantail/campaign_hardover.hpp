// SPDX-License-Identifier: MIT
#pragma once

#include "fantail/command_line.hpp"

namespace fantail::tool {

/// `campaign hardover`: what one canard that fails does to the flight.
void fill_hardover(const Verb& verb);

}  // namespace fantail::tool
