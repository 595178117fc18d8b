// SPDX-License-Identifier: MIT
#pragma once

#include "hal/can_bus.hpp"
#include "protocol/bus_codec.hpp"

namespace fantail::avionics {

// A frame of the bus as the hardware layer carries it, and back.

[[nodiscard]] constexpr hal::CanFrame can_frame(const protocol::BusFrame& frame) {
  return {.id = frame.id, .length = frame.length, .data = frame.data};
}

/// For a data frame with an 11-bit identifier; no other is part of the protocol.
[[nodiscard]] constexpr protocol::BusFrame bus_frame(const hal::CanFrame& frame) {
  return {.id = static_cast<std::uint16_t>(frame.id), .length = frame.length, .data = frame.data};
}

}  // namespace fantail::avionics
