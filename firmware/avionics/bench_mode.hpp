// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "avionics/situation.hpp"
#include "core/flight_plan.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::avionics {

/// The right of a bench to move the canards. It is given in Safe, to one bench at a time, while the rocket stands
/// still; it ends with the phase, with motion, on request, or when the bench has been silent for 100 ms. Then nothing
/// asks for an angle any more, and the canards go to their trims. The number that a bench draws for its session is what
/// it is known by: what another bench says changes nothing, and neither does an `open` that is refused.
class BenchMode {
 public:
  static constexpr core::Microseconds patience{100'000};

  /// False: it concerns a session that is not open, and nothing was done.
  bool receive(const Situation& now, bool self_test_runs, const protocol::BenchSession& message);
  /// Of the open session, which the receiver has made sure of.
  bool receive(const protocol::BenchRequest& message);

  /// Once a tick, after what was received.
  void update(const Situation& now);

  [[nodiscard]] bool open() const { return session_.has_value(); }
  /// The number of the open one.
  [[nodiscard]] std::optional<std::uint16_t> session() const { return session_; }

  /// Shaft angles for the autopilot, the trim for a canard that was not asked; empty outside a session and before its
  /// first request.
  [[nodiscard]] std::optional<std::array<core::Angle, core::canard_count>> canard_request(
      const core::CanardsPlan& canards) const;

  /// The state and why.
  [[nodiscard]] const protocol::SessionReply& reply() const { return reply_; }
  /// True once, if that answer has not been sent yet.
  [[nodiscard]] bool take_news() { return std::exchange(news_, false); }
  /// The answer to an `open` that was refused, once: the state has not changed by it.
  [[nodiscard]] std::optional<protocol::SessionReply> take_refusal() { return std::exchange(refusal_, std::nullopt); }

 private:
  [[nodiscard]] std::optional<protocol::SessionReason> objection(const Situation& now, bool self_test_runs,
                                                                 std::uint16_t session) const;
  void become(protocol::SessionState state, protocol::SessionReason reason, std::uint16_t session);
  void close(protocol::SessionReason reason);

  std::optional<std::uint16_t> session_;
  std::optional<std::uint16_t> before_;  ///< the last one that was closed, whose bench may not know that yet
  core::Microseconds last_heard_{};
  std::optional<protocol::BenchRequest> request_;
  protocol::SessionReply reply_{};
  std::optional<protocol::SessionReply> refusal_;
  bool news_ = false;
};

}  // namespace fantail::avionics
