// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "board_flight.hpp"
#include "core/flight_plan.hpp"

namespace fantail::board {

/// What the servos of a flight have heard since somebody began to look, and what the plan allows.
struct Pins {
  double narrowest_us = 1e9;  ///< of whole pulses, as the next four
  double widest_us = 0.0;
  double farthest_us = 0.0;  ///< from the plan's centre
  int beyond_plan = 0;       ///< farther than the plan's limit for this canard
  int beyond_hard = 0;       ///< farther than core::hard_canard_limit, or than the proof canard_pulse says
  int cut = 0;
  double silence_ms = 0.0;         ///< the longest without a pulse on one of the lines
  double longest_beyond_ms = 0.0;  ///< how long a modelled servo stood beyond the plan's limit
};

/// Looks at the pins of a flight, a millisecond at a time.
class PinWatch {
 public:
  /// From this instant of the board on.
  PinWatch(BoardFlight& flight, const core::FlightPlan& plan, double from_s);
  /// After each step of the flight.
  void follow();
  [[nodiscard]] const Pins& pins() const { return pins_; }

 private:
  struct Canard {
    double centre_us;
    double plan_us;  ///< this far from the centre at most
    double hard_us;
    double plan_deg;
    double last_s;           ///< when its last pulse ended
    double beyond_ms = 0.0;  ///< that it has stood there
  };

  void look_at(const HeardPulse& pulse);

  BoardFlight& flight_;
  double from_s_;
  std::size_t seen_;
  std::array<Canard, hal::canards> canards_{};
  Pins pins_;
};

/// By so much a pulse may miss its angle: it is whole steps of a timer.
inline constexpr double pulse_step_us = 0.2;

}  // namespace fantail::board
