// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "log_export/source.hpp"

namespace fantail::log_export {

/// What the avionics would have put on the bus, as `candump -l` writes it down: "(12.345678) can0
/// 0A0#0011223344556677", with the board's time. Commands, encoders, status, motion, health, limits and heartbeat, as
/// often as the avionics sends them; answers to a bench are not in a flight log, and so not here. What only the bus
/// knew is zero.
[[nodiscard]] std::string candump(const Source& source);

}  // namespace fantail::log_export
