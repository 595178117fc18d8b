// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <stdexcept>

#include "board.hpp"

namespace fantail::board {

/// How long the ticks of a board's avionics take, from where the firmware has waited for one to where it returns.
class TickMeter {
 public:
  /// The board outlives it, and calls it from then on. Throws std::runtime_error when the image has no such functions.
  TickMeter(const Image& image, Board& board) {
    const auto wait = image.address_of("_ZN7fantail6boards9stm32f4058Hardware13wait_for_tickEv");
    const auto tick = image.address_of("_ZN7fantail8avionics8Avionics4tickEv");
    const auto write = image.address_of(
        "_ZN7fantail3hal7stm32f45Servo5writeERKSt5arrayISt8optionalINSt6chrono8durationIlSt5ratioILx1ELx1000000000EEEEE"
        "Lj4EE");
    if (!wait || !tick || !write) {
      throw std::runtime_error{image.file().string() + ": no function waits for a tick, or none writes pulses"};
    }
    board.processor.on_return_of(*wait, [this, &board](std::uint32_t) { began_s_ = board.now_s(); });
    board.processor.on_return_of(*tick, [this, &board](std::uint32_t) {
      ticks_ += 1;
      longest_s_ = std::max(longest_s_, board.now_s() - began_s_);
    });
    board.processor.on_return_of(*write, [this, &board](std::uint32_t) {
      last_written_s_ = std::max(last_written_s_, board.now_s() - began_s_);
    });
  }
  TickMeter(const TickMeter&) = delete;  // the board points to it
  TickMeter& operator=(const TickMeter&) = delete;

  void forget() { longest_s_ = last_written_s_ = 0.0; }
  [[nodiscard]] double began_s() const { return began_s_; }  ///< the latest tick
  [[nodiscard]] double longest_s() const { return longest_s_; }
  /// From the beginning of a tick to its pulses in the registers of the timer, at most.
  [[nodiscard]] double last_written_s() const { return last_written_s_; }
  [[nodiscard]] int ticks() const { return ticks_; }

 private:
  double began_s_ = 0.0;
  double longest_s_ = 0.0;
  double last_written_s_ = 0.0;
  int ticks_ = 0;
};

}  // namespace fantail::board
