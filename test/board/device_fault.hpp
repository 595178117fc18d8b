// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "board_wires.hpp"

namespace fantail::board {

/// One device that fails in one way, and stays so.
struct DeviceFault {
  std::string device;
  std::string how;
  bool is_named = true;            ///< under control somebody tells of it: bus, console, verdict or reason
  bool needs_all_sensors = false;  ///< the plan must use the second IMU and the barometer
  std::function<void(Board& board, BoardWires& wires)> begin;
  /// Under control instead of that; empty: the same.
  std::function<void(Board& board)> in_flight{};
  /// Again in each millisecond from then on.
  std::function<void(Board& board)> go_on{};
};

/// Every device of the board with everything that may happen to it.
[[nodiscard]] std::vector<DeviceFault> device_faults();

}  // namespace fantail::board
