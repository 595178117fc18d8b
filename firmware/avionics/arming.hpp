// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "avionics/self_test.hpp"
#include "avionics/situation.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::avionics {

/// The second of the two actions that arm; the first is a hand on the arm switch. It takes two steps: `begin` is
/// answered with a nonce, and `confirm` must bring it back within 5 s. A nonce is good for one attempt, and that a
/// later one is the same has a chance of 2^-32: it is made of the number of this power-up, which the flash counts, of
/// the number of the request, and of a random number. So frames that were recorded do not arm. After a reset everything
/// has to be done again, the switch included.
class Arming {
 public:
  static constexpr core::Microseconds nonce_lifetime{5'000'000};

  /// What decides besides the situation.
  struct Permission {
    bool self_test_passed = false;
    bool session_open = false;
    bool tunnel_plan = false;
    /// Which one this is, at least for the next 65536; empty while the flash has not counted it.
    std::optional<std::uint32_t> power_up{};
    std::uint32_t random = 0;  ///< fresh with every request
  };

  /// begin, confirm or start; a self_test is not its business. A refused begin leaves a nonce that was given before.
  void receive(const Situation& now, const Permission& permission, const protocol::ArmRequest& request);
  /// To a self_test.
  void answer(protocol::ArmRefusal refusal) { refusal_ = refusal; }

  /// Once a tick, when the switch has been read.
  void update(const Situation& now);

  /// True once, in the tick after a confirmation.
  [[nodiscard]] bool take_arm_command();
  /// True once: begin control in the tunnel.
  [[nodiscard]] bool take_start_command();

  [[nodiscard]] protocol::ArmRefusal refusal() const { return refusal_; }
  /// The nonce to be confirmed; empty when there is none.
  [[nodiscard]] std::optional<std::uint32_t> nonce() const;

 private:
  struct Issued {
    std::uint32_t nonce;
    core::Microseconds time;
  };

  void expire(core::Microseconds now);
  [[nodiscard]] protocol::ArmRefusal objection(const Situation& now, const Permission& permission) const;
  [[nodiscard]] protocol::ArmRefusal objection_to_nonce(std::uint32_t nonce) const;
  [[nodiscard]] protocol::ArmRefusal objection_to_start(const Situation& now, const Permission& permission,
                                                        std::uint32_t nonce) const;
  [[nodiscard]] std::optional<std::uint32_t> fresh_nonce(const Permission& permission);

  bool switch_was_open_ = false;
  std::optional<Issued> issued_;
  bool expired_ = false;  ///< the last one
  std::optional<std::uint32_t> armed_with_;
  bool arm_command_ = false;
  bool start_command_ = false;
  protocol::ArmRefusal refusal_ = protocol::ArmRefusal::none;
  std::uint32_t requests_ = 0;
};

}  // namespace fantail::avionics
