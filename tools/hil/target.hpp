// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "hil/link.hpp"
#include "sim/flight_computer.hpp"
#include "world_link/exchange.hpp"

namespace fantail::hil {

/// What a flight computer says of itself.
struct TargetIdentity {
  std::string image;
  std::string version;
  std::string git_hash;
  std::uint32_t instructions = 0;  ///< of a loop that it measured at start-up; 0: it did not
  std::uint32_t counts = 0;        ///< of its clock, for that loop
};

/// A flight computer at the end of a wire, to be flown by a world.
class Target {
 public:
  /// Throws TargetError when nobody answers, and text::Error when who answers speaks another language.
  explicit Target(std::unique_ptr<Wire> wire, Waiting waiting = {}, const Patience& patience = {});

  [[nodiscard]] const TargetIdentity& identity() const { return identity_; }
  /// For sim::World: the avionics is made anew at the first tick. This object outlives it.
  [[nodiscard]] sim::MakeFlightComputer maker();

  /// Of the last tick.
  [[nodiscard]] const world_link::TickTimes& times() const { return times_; }
  [[nodiscard]] const Link& link() const { return link_; }

 private:
  friend class RemoteBoard;

  Link link_;
  TargetIdentity identity_;
  world_link::TickTimes times_;
};

}  // namespace fantail::hil
