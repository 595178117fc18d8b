// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include <lcm/lcm.h>

#include "telemetry/packet.hpp"

namespace fantail::telemetry {

/// Appends a packet to an LCM log, with the avionics' clock. False: it was not written.
[[nodiscard]] inline bool write_event(lcm_eventlog_t& log, const Packet& packet) {
  std::string channel{name(packet.channel)};
  auto bytes = packet.bytes;
  lcm_eventlog_event_t event{.eventnum = 0,
                             .timestamp = packet.time.count(),
                             .channellen = static_cast<std::int32_t>(channel.size()),
                             .datalen = static_cast<std::int32_t>(packet.size),
                             .channel = channel.data(),
                             .data = bytes.data()};
  return lcm_eventlog_write_event(&log, &event) == 0;
}

}  // namespace fantail::telemetry
