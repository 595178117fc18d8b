// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "hil/target.hpp"

namespace fantail::hil {

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
