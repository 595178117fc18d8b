// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_phase.hpp"
#include "core/time.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::avionics {

/// Where the rocket stood after the last tick: what decides whether somebody on the ground may do something.
struct Situation {
  core::Microseconds time{};
  core::Phase phase = core::Phase::safe;
  core::PhaseReason reason = core::PhaseReason::power_on;
  bool at_rest = false;  ///< for the plan's rest time, up to now
  bool moves = false;    ///< not at rest at all
  bool arm_switch_closed = false;
  bool arm_switch_open = false;  ///< neither of the two: not known yet
  protocol::AbortState abort = protocol::AbortState::none_fitted;
  bool board_faulty = false;
};

}  // namespace fantail::avionics
