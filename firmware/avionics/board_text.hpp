// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hal/board.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::avionics {

// For a person, at the console or at a bench; no program parses it.

/// "reset by the watchdog"
[[nodiscard]] constexpr std::string_view text(hal::ResetCause cause) {
  switch (cause) {
    case hal::ResetCause::power_on: return "reset by power-on";
    case hal::ResetCause::brown_out: return "reset by a supply that was too low";
    case hal::ResetCause::pin: return "reset by its button or a probe";
    case hal::ResetCause::software: return "reset by the firmware itself";
    case hal::ResetCause::watchdog: return "reset by the watchdog";
  }
  return "reset by something unknown";
}

/// Which one is in force, and what to do where that is not the stored one.
[[nodiscard]] constexpr std::string_view text(protocol::PlanSource plan) {
  using protocol::PlanSource;
  switch (plan) {
    case PlanSource::built_in: return "the built-in one; none is stored";
    case PlanSource::stored: return "the one in the flash";
    case PlanSource::stored_is_broken:
      return "the built-in one; the stored one is broken; it will not be armed until a plan is sent";
    case PlanSource::stored_is_newer:
      return "the built-in one; the stored one is from a newer version of the firmware; it will not be armed until "
             "that is flashed or a plan is sent";
    case PlanSource::flash_unreadable: return "the built-in one; the flash cannot be read, and it will not be armed";
  }
  return "unknown";
}

}  // namespace fantail::avionics
