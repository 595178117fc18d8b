// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "telemetry/sink.hpp"

namespace fantail::telemetry {

/// Different for every start of a sender.
[[nodiscard]] std::int64_t new_run();

/// Numbers the messages of each channel. A message that is lost on any later step leaves a gap in the numbers.
class Sender {
 public:
  explicit Sender(Sink& sink, std::int64_t run = new_run()) : sink_{sink}, run_{run} {}

  template <typename Content>
  void send(Channel channel, core::Microseconds time, const Content& content) {
    std::int64_t& sequence = next_[static_cast<std::size_t>(channel)];
    sink_.send(encode(Stamp{.run = run_, .sequence = sequence, .time = time}, content));
    sequence += 1;
  }
  void send(core::Microseconds time, const State& state) { send(Channel::state, time, state); }
  void send(core::Microseconds time, const Canards& canards) { send(Channel::canards, time, canards); }
  void send(core::Microseconds time, const Event& event) { send(Channel::event, time, event); }
  void send(core::Microseconds time, const Health& health) { send(Channel::health, time, health); }

 private:
  Sink& sink_;
  std::int64_t run_;
  std::array<std::int64_t, channel_count> next_{};
};

}  // namespace fantail::telemetry
