// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "logs/roll_log.hpp"

namespace fantail::logs {

/// Takes whole turns out of a roll angle that is kept between two limits one turn apart, with the roll rate as witness.
/// Returns how many jumps there were.
std::size_t continue_over_turns(RollLog& log);

}  // namespace fantail::logs
