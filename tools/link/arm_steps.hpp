// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>

#include "link/avionics_link.hpp"
#include "link/place.hpp"

namespace fantail::link {

/// The avionics did not begin the self-test. what() is the reason; an earlier test stays valid.
class SelfTestRefused : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Which canard the self-test moves, each said once.
class CanardUnderTest {
 public:
  /// The canard, from 0, when this reply is the first that names it; empty otherwise.
  [[nodiscard]] std::optional<std::size_t> news(const protocol::ArmReply& reply);

 private:
  std::optional<std::size_t> last_;
};

/// The steps of arming. All throw LinkError without an answer for two seconds, and TwoRockets. A report does not name
/// its sender, so a single frame decides nothing: a state must be reported twice.
class ArmSteps {
 public:
  ArmSteps(Place& place, AvionicsLink& link) : place_{place}, link_{link} {}

  /// Until the self-test has passed or failed. `progress` is called with every new state. Throws SelfTestRefused.
  [[nodiscard]] protocol::ArmReply run_self_test(const std::function<void(const protocol::ArmReply&)>& progress);

  /// The answer to `begin`: a nonce or a refusal.
  [[nodiscard]] protocol::ArmReply ask_for_nonce();

  /// True when the avionics is armed; otherwise the link's newest ArmReply says why not.
  [[nodiscard]] bool confirm(std::uint32_t nonce);

  /// True when control has started in the tunnel.
  [[nodiscard]] bool start_control(std::uint32_t nonce);

 private:
  void send(protocol::ArmAction action, std::uint32_t nonce = 0);
  void look();
  [[nodiscard]] bool reaches(core::Phase phase);
  [[nodiscard]] bool stands(const protocol::ArmReply& reply);

  Place& place_;
  AvionicsLink& link_;
  protocol::FrameCounter counter_;
  int contradictions_ = 0;
};

}  // namespace fantail::link
