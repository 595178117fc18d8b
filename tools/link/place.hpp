// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <stdexcept>

#include "hal/can_bus.hpp"
#include "hal/clock.hpp"

namespace fantail::link {

/// The avionics does not answer, refuses, or has ended the session. what() is a sentence for a person.
class LinkError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// More than one avionics reports on the bus, so a report cannot be assigned to a rocket.
class TwoRockets : public LinkError {
  using LinkError::LinkError;
};

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

/// A timeout. To be checked at every look; the time between two looks counts for 0.25 s at most, because a PC that held
/// up this process received nothing meanwhile, and an avionics on the same PC could not send.
class Timeout {
 public:
  Timeout(hal::Microseconds longest, hal::Microseconds now) : longest_{longest}, last_look_{now} {}

  [[nodiscard]] bool expired(hal::Microseconds now) {
    waited_ += std::clamp(now - last_look_, hal::Microseconds{0}, longest_stride);
    last_look_ = now;
    return waited_ >= longest_;
  }
  /// What was waited for has come, and the next of its kind is waited for as long.
  void restart() { waited_ = {}; }

 private:
  static constexpr hal::Microseconds longest_stride{250'000};

  hal::Microseconds longest_;
  hal::Microseconds last_look_;
  hal::Microseconds waited_{};
};

}  // namespace fantail::link
