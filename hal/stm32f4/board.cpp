// SPDX-License-Identifier: MIT
#include "hal/stm32f4/board.hpp"

#include <cstddef>

#include "hal/signal_pattern.hpp"

namespace fantail::hal::stm32f4 {

BoardStatus Board::status() {
  if (parts_.entropy.failed()) {
    faults_.add(BoardFault::entropy_failed);
  }
  BoardStatus result{
      .faults = faults_, .reset_cause = reset_cause_, .battery_mv = parts_.battery.millivolts(), .overruns = overruns_};
  result.faults.add(faults_now_);
  if (parts_.battery.failed()) {
    result.faults.add(BoardFault::battery_unmeasured);  // it may answer again
  }
  return result;
}

void Board::show(Signal signal) {
  if (signal != shown_) {
    shown_ = signal;
    tick_of_pattern_ = 0;
  }
  const std::size_t step = tick_of_pattern_ / ticks_per_pattern_step;
  parts_.light.set(pattern(signal).light[step] == '#');
  parts_.buzzer.sound(pattern(signal).sound[step] == '#');
  tick_of_pattern_ = (tick_of_pattern_ + 1) % (pattern_steps * ticks_per_pattern_step);
}

}  // namespace fantail::hal::stm32f4
