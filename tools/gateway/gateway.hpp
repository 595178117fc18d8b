// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "hal/can_bus.hpp"
#include "hal/clock.hpp"
#include "link/avionics_link.hpp"
#include "link/heartbeats.hpp"
#include "telemetry/sender.hpp"

namespace fantail::gateway {

/// The avionics' clock, as far as its heartbeats show it: ten a second, in milliseconds, and a frame may be delayed on
/// its way. Never goes backwards, except when the avionics has been switched on again.
class AvionicsClock {
 public:
  /// A heartbeat came. True: the avionics has been switched on again since the one before.
  bool hear(std::uint32_t uptime_ms, hal::Microseconds now);

  /// Empty before the first heartbeat.
  [[nodiscard]] std::optional<hal::Microseconds> at(hal::Microseconds now);

 private:
  [[nodiscard]] hal::Microseconds uptime() const { return std::chrono::milliseconds{uptime_->total()}; }

  std::optional<link::UptimeCounter> uptime_;  ///< of the last heartbeat
  hal::Microseconds last_heard_{};
  hal::Microseconds ahead_{};  ///< what the avionics' clock is before ours
  hal::Microseconds told_{};
};

/// A bus on which nothing can be sent.
class ListenOnlyBus final : public hal::CanBus {
 public:
  explicit ListenOnlyBus(hal::CanBus& bus) : bus_{bus} {}
  bool send(const hal::CanFrame& /*frame*/) override { return false; }
  std::optional<hal::CanFrame> receive() override { return bus_.receive(); }
  [[nodiscard]] hal::CanState state() const override { return bus_.state(); }
  [[nodiscard]] hal::CanCounters counters() const override { return bus_.counters(); }

 private:
  hal::CanBus& bus_;
};

/// From the frames of a real bus to the same messages that a simulated flight sends. Values that no frame contains stay
/// unknown: reference, excitation, specific force and the command before its limit. Until the first heartbeat, which
/// tells the avionics' time, nothing is sent.
class Gateway {
 public:
  Gateway(hal::CanBus& bus, telemetry::Sink& sink) : bus_{bus}, sink_{sink} { changes_.begin_with_first_look(); }

  /// Takes in what has arrived, and sends what is due.
  void listen(hal::Microseconds now);

  [[nodiscard]] const link::LinkFigures& heard() const { return link_.figures(); }
  [[nodiscard]] std::uint32_t overrun() const { return bus_.counters().overrun; }
  [[nodiscard]] hal::CanState bus_state() const { return bus_.state(); }
  [[nodiscard]] int restarts() const { return restarts_; }
  /// Throws link::TwoRockets: messages of both would be sent as of one.
  void expect_one_rocket() const { link_.expect_one_rocket(); }

 private:
  template <typename Message>
  [[nodiscard]] const Message* news(std::uint64_t& taken) const;
  void pass_on(hal::Microseconds now);
  void follow_clock(hal::Microseconds now);
  void send_state(hal::Microseconds now, core::Microseconds time);
  void send_canards(hal::Microseconds now, core::Microseconds time);
  void send_health(core::Microseconds time);

  ListenOnlyBus bus_;
  telemetry::Sink& sink_;
  link::AvionicsLink link_{bus_};
  AvionicsClock clock_;
  std::optional<telemetry::Sender> sender_;  ///< empty until the avionics' time is known
  telemetry::Changes changes_;
  int restarts_ = 0;
  std::uint64_t heartbeats_ = 0;
  std::uint64_t states_ = 0;
  std::uint64_t motions_ = 0;
  std::uint64_t healths_ = 0;
  std::optional<core::Microseconds> canards_sent_;
  std::optional<link::WrappingCounter<256>> unsent_;  ///< modulo 256, as the two below
  std::optional<link::WrappingCounter<256>> overrun_;
  std::optional<link::WrappingCounter<256>> errors_;
};

}  // namespace fantail::gateway
