// SPDX-License-Identifier: MIT
#pragma once

#include "hal/can_bus.hpp"
#include "hal/clock.hpp"

namespace fantail::link {

/// Where a bench stands: at a real bus, where waiting takes time, or at a simulated one, which moves on while the bench
/// waits. So a procedure is written once, from top to bottom, and every test of it is the procedure itself.
class Place {
 public:
  virtual ~Place() = default;
  [[nodiscard]] virtual hal::CanBus& bus() = 0;
  [[nodiscard]] virtual hal::Microseconds now() const = 0;
  /// Until something may have arrived, and a few milliseconds longer to let more arrive; no longer than this. Throws
  /// whatever should end the procedure.
  virtual void wait(hal::Microseconds at_most) = 0;
};

}  // namespace fantail::link
