// SPDX-License-Identifier: MIT
#pragma once

#include <variant>
#include <vector>

#include "telemetry/sender.hpp"

namespace fantail::test {

/// Keeps what is sent.
class Collected final : public telemetry::Sink {
 public:
  void send(const telemetry::Packet& packet) override { packets.push_back(packet); }

  /// All of one kind, decoded.
  template <typename Content>
  [[nodiscard]] std::vector<Content> all() const {
    std::vector<Content> found;
    for (const telemetry::Packet& packet : packets) {
      const auto decoded = telemetry::decode(packet.channel, packet.content());
      if (decoded && std::holds_alternative<Content>(decoded->content)) {
        found.push_back(std::get<Content>(decoded->content));
      }
    }
    return found;
  }
  [[nodiscard]] std::vector<telemetry::Stamp> stamps(telemetry::Channel channel) const {
    std::vector<telemetry::Stamp> found;
    for (const telemetry::Packet& packet : packets) {
      if (packet.channel == channel) {
        found.push_back(telemetry::decode(channel, packet.content()).value().stamp);
      }
    }
    return found;
  }

  std::vector<telemetry::Packet> packets;
};

}  // namespace fantail::test
