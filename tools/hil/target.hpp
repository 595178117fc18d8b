// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

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

/// The avionics of a flight computer at the end of a wire, with the world's devices.
class RemoteBoard final : public sim::FlightComputer {
 public:
  RemoteBoard(Target& target, const core::FlightPlan& plan, const sim::BoardPorts& ports,
              const avionics::Identity& identity)
      : target_{target}, plan_{plan}, ports_{ports}, vehicle_{identity.vehicle}, sensors_{identity.sensors} {}

  [[nodiscard]] hal::sim::WorldSide& hardware() override { return hardware_; }
  /// Throws TargetError.
  const core::TickRecord& tick() override;

 private:
  void begin();
  [[nodiscard]] protocol::LogFrame ask(protocol::HilType question, std::size_t size, protocol::HilType wanted);
  [[nodiscard]] std::size_t do_as_asked(std::span<const std::byte> flash_request);

  Target& target_;
  core::FlightPlan plan_;
  sim::BoardPorts ports_;
  std::string vehicle_;
  std::string sensors_;
  hal::sim::WorldSide hardware_;
  core::TickRecord record_;
  std::vector<hal::CanFrame> frames_;
  std::vector<std::byte> read_;
  bool begun_ = false;
};

}  // namespace fantail::hil
