// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "hal/board.hpp"
#include "hal/stm32f4/battery.hpp"
#include "hal/stm32f4/buzzer.hpp"
#include "hal/stm32f4/cycle_counter.hpp"
#include "hal/stm32f4/entropy.hpp"
#include "hal/stm32f4/pin.hpp"

namespace fantail::hal::stm32f4 {

/// Collects what the drivers found out, and shows the avionics' signal with lamp and buzzer.
class Board final : public hal::Board {
 public:
  /// They outlive this object.
  struct Parts {
    Pin light;
    Buzzer& buzzer;
    const Battery& battery;
    const Entropy& entropy;
    CycleCounter& cycles;  ///< of each tick
  };

  Board(Parts parts, ResetCause reset_cause) : parts_{parts}, reset_cause_{reset_cause} {}

  /// What the processor calls a software reset is also what a probe asks for. Before anybody has asked for the status.
  void was_reset_by(ResetCause cause) { reset_cause_ = cause; }
  /// A fault stays until the next reset.
  void add(BoardFault fault) { faults_.add(fault); }
  void add(BoardFaults faults) { faults_.add(faults); }
  /// Faults that come and go with their devices, in the place of those said last.
  void set_now(BoardFaults faults) { faults_now_ = faults; }
  void add_overruns(std::uint32_t ticks) { overruns_ += ticks; }

  [[nodiscard]] BoardStatus status() override;
  std::optional<std::uint32_t> take_longest_tick_cycles() override { return parts_.cycles.take_longest(); }
  void show(Signal signal) override;

 private:
  Parts parts_;
  ResetCause reset_cause_;
  BoardFaults faults_{};
  BoardFaults faults_now_{};
  std::uint32_t overruns_ = 0;
  Signal shown_ = Signal::safe;
  std::uint32_t tick_of_pattern_ = 0;
};

}  // namespace fantail::hal::stm32f4
