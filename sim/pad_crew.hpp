// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "hal/clock.hpp"
#include "hal/sim/can_bus.hpp"
#include "protocol/bus_codec.hpp"

namespace fantail::sim {

/// The people at the pad, as the avionics knows them: a hand on the arm switch, and a PC on the bus that asks for the
/// self-test, then for a nonce, and confirms it. A self-test that is refused or fails they ask for again, for a second;
/// they give up on any other refusal.
class PadCrew {
 public:
  PadCrew(hal::sim::CanWire& wire, hal::Microseconds arm_time) : bus_{wire}, arm_time_{arm_time} {}

  /// Once a tick, before the avionics has its own.
  void act(hal::Microseconds now);

  [[nodiscard]] bool switch_closed() const { return stage_ != Stage::waiting || next_try_ != arm_time_; }

  /// In the tunnel: ask for control to start. Says nothing when the avionics was never armed.
  void start_tunnel();

  /// What the avionics answered when it would not be armed.
  [[nodiscard]] const std::optional<protocol::ArmReply>& refusal() const { return refusal_; }

  /// All faults that the board has told by then, as BoardReport has them.
  [[nodiscard]] std::uint32_t board_faults() const { return board_faults_; }

 private:
  enum class Stage : std::uint8_t { waiting, testing, asking, confirming, done };

  [[nodiscard]] std::optional<protocol::ArmReply> newest_reply();
  void send(protocol::ArmAction action, std::uint32_t nonce = 0);
  void give_up(const protocol::ArmReply& reply);

  hal::sim::CanBus bus_;
  hal::Microseconds arm_time_;
  hal::Microseconds next_try_ = arm_time_;
  Stage stage_ = Stage::waiting;
  protocol::FrameCounter counter_;
  std::optional<std::uint32_t> nonce_;
  std::optional<protocol::ArmReply> refusal_;
  std::uint32_t board_faults_ = 0;
};

}  // namespace fantail::sim
