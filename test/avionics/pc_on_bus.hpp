// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <variant>

#include "avionics/can_frame.hpp"
#include "hal/sim/can_bus.hpp"
#include "protocol/bus_codec.hpp"

namespace fantail::avionics {

/// A PC on a bus: says what a bench says, and keeps the newest message of every kind that it has heard.
class PcOnBus {
 public:
  explicit PcOnBus(hal::sim::CanWire& wire) : bus{wire} {}

  void send(const protocol::BusFrame& frame) { (void)bus.send(can_frame(frame)); }
  void say(const protocol::BenchRequest& message) { send(encode(message, counters_[0].next(), session)); }
  void say(const protocol::BenchSession& message) {
    session = message.session;
    send(encode(message, counters_[1].next()));
  }
  void say(const protocol::ArmRequest& message) { send(encode(message, counters_[2].next())); }
  void say(const protocol::PlanBegin& message) { send(encode(message, counters_[3].next())); }
  void say(const protocol::PlanData& message) { send(encode(message)); }
  void say(const protocol::LogRequest& message) { send(encode(message, counters_[4].next())); }
  void say(protocol::ArmAction action, std::uint32_t nonce = 0) {
    say(protocol::ArmRequest{.action = action, .nonce = nonce});
  }

  /// As if it had said one thing more of every kind, which nobody heard.
  void skip_a_counter() {
    for (protocol::FrameCounter& counter : counters_) {
      (void)counter.next();
    }
  }

  /// Takes what has come.
  void listen() {
    while (const auto frame = bus.receive()) {
      const auto decoded = protocol::decode_from_avionics(bus_frame(*frame));
      if (decoded.message) {
        counts_[decoded.message->index()] += 1;
        std::visit(
            [this](const auto& message) { std::get<std::optional<std::decay_t<decltype(message)>>>(heard_) = message; },
            *decoded.message);
      }
    }
  }
  /// The newest message of a kind since power-up.
  template <typename Message>
  [[nodiscard]] const std::optional<Message>& heard() const {
    return std::get<std::optional<Message>>(heard_);
  }
  template <typename Message>
  [[nodiscard]] int count() const {
    return counts_[protocol::FromAvionics{Message{}}.index()];
  }

  hal::sim::CanBus bus;
  std::uint16_t session = 7;  ///< for which it asks: the one that it has named last

 private:
  template <typename... Messages>
  static std::tuple<std::optional<Messages>...> one_of_each(const std::variant<Messages...>&);

  std::array<protocol::FrameCounter, 5> counters_{};
  decltype(one_of_each(protocol::FromAvionics{})) heard_{};
  std::array<int, std::variant_size_v<protocol::FromAvionics>> counts_{};
};

}  // namespace fantail::avionics
