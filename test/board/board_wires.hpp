// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <map>

#include "board.hpp"
#include "devices/wire_fault.hpp"

namespace fantail::board {

/// Wires that may fail between the processor of a board and each of its devices.
class BoardWires {
 public:
  /// The board outlives it and stays wired so.
  explicit BoardWires(Board& board) {
    add(board.imu, board.second_imu, board.accelerometer, board.barometer, board.flash);
    for (devices::FakeAs5047p& encoder : board.encoders) {
      add(encoder);
    }
    board.wire = [this](devices::SpiSlave& device) -> devices::SpiSlave& { return of(device); };
    board.connect();
  }
  BoardWires(const BoardWires&) = delete;  // the board points into it
  BoardWires& operator=(const BoardWires&) = delete;

  [[nodiscard]] fantail::devices::WireFault& of(devices::SpiSlave& device) { return *wires_.at(&device); }

 private:
  template <typename... Devices>
  void add(Devices&... each) {
    ((wires_[&each] = &all_.emplace_back(each, 1U)), ...);
  }

  std::deque<fantail::devices::WireFault> all_;
  std::map<devices::SpiSlave*, fantail::devices::WireFault*> wires_;
};

}  // namespace fantail::board
