// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "log_export/source.hpp"

namespace fantail::log_export {

/// An LCM log for lcm-logplayer, with the board's clock: the messages of a live flight, but state and canards of every
/// replayed tick. Health and events are those that stand in the log.
[[nodiscard]] std::string lcm(const Source& source);

}  // namespace fantail::log_export
