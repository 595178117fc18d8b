// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "telemetry/messages.hpp"

namespace fantail::telemetry {

/// Takes packets, at once and without waiting; what it has no room for it counts itself.
class Sink {
 public:
  virtual ~Sink() = default;
  virtual void send(const Packet& packet) = 0;
};

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

/// Makes an event of every change of the phase and of each verdict. What was so when it began to look is no change,
/// except that the avionics begins in Safe with healthy canards.
class Changes {
 public:
  void look(core::Microseconds time, core::Phase phase, core::PhaseReason reason, Sender& sender);
  void look(core::Microseconds time, const Each<core::CanardVerdict>& verdicts, Sender& sender);

  /// For who comes late: the first look is where it begins.
  void begin_with_first_look() {
    phase_.reset();
    verdicts_.reset();
  }

 private:
  std::optional<core::Phase> phase_{core::Phase::safe};
  std::optional<Each<core::CanardVerdict>> verdicts_{Each<core::CanardVerdict>{}};
};

}  // namespace fantail::telemetry
