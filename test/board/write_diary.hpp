// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "board_server.hpp"

namespace fantail::board {

/// What was measured at the pins of a board that has flown: board_pulses.csv, every pulse that the servos have heard;
/// board_can.log, the traffic of its bus, as candump writes it; board_console.txt. Times are seconds since its
/// power-up. Throws std::ios_base::failure.
void write_diary(BoardServer& server, const std::filesystem::path& folder);

}  // namespace fantail::board
