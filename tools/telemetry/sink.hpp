// SPDX-License-Identifier: MIT
#pragma once

#include "telemetry/packet.hpp"

namespace fantail::telemetry {

/// Takes packets, at once and without waiting; what it has no room for it counts itself.
class Sink {
 public:
  virtual ~Sink() = default;
  virtual void send(const Packet& packet) = 0;
};

}  // namespace fantail::telemetry
