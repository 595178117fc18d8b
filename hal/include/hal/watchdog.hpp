// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::hal {

/// Resets the processor unless it is fed in time. It runs from power-up and cannot be stopped.
class Watchdog {
 public:
  virtual ~Watchdog() = default;
  /// At the very end of each tick: only a loop that comes that far is alive.
  virtual void feed() = 0;
};

}  // namespace fantail::hal
