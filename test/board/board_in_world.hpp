// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "board.hpp"
#include "core/tick_record.hpp"
#include "hal/sim/flash.hpp"
#include "hal/sim/world_side.hpp"
#include "protocol/bus_messages.hpp"
#include "sim/flight_computer.hpp"

namespace fantail::board {

/// A virtual board in a simulated world: its sensors measure what the world says, and the world hears the pulses at its
/// pins, reads its console, and has its bus and what it writes into its flash.
///
/// The world's time begins with its power-up. A tick of the world is a millisecond of the board, and has one of the
/// avionics while that runs.
class BoardInWorld final : public sim::FlightComputer {
 public:
  /// The image and the ports outlive it. `plan` goes into the flash before the board is switched on. Throws text::Error
  /// when the image has no avionics in it, or when it never comes to its first tick.
  BoardInWorld(const Image& image, const Pace& pace, const core::FlightPlan& plan, const sim::BoardPorts& ports);
  /// With this content of its flash, and from its power-up on: no time has passed yet.
  BoardInWorld(const Image& image, const Pace& pace, std::vector<std::byte> flash, const sim::BoardPorts& ports);

  [[nodiscard]] hal::sim::WorldSide& hardware() override { return hardware_; }
  const core::TickRecord& tick() override;
  core::Microseconds restart(const sim::Reset& reset) override;

  [[nodiscard]] Board& board() { return board_; }
  /// The avionics had a tick in the last one of the world.
  [[nodiscard]] bool had_tick() const { return hardware_.had_tick; }
  /// What the board said of itself last, on its bus.
  [[nodiscard]] const std::optional<protocol::BoardReport>& report() const { return report_; }

 private:
  void show_world();
  void note_attendance();
  void hear_pulses();
  void note_report(const hal::CanFrame& frame);
  void mirror(std::size_t address, std::size_t size);
  void take_record(std::uint32_t address);

  const Image& image_;
  Board board_;
  sim::BoardPorts ports_;
  hal::sim::WorldSide hardware_;
  core::TickRecord record_{};
  bool has_begun_ = false;   ///< a tick, in the last one of the world
  bool has_record_ = false;  ///< one has ended in it
  bool has_ever_ticked_ = false;
  std::optional<protocol::BoardReport> report_;
  double last_tick_ended_s_ = 0.0;
  double until_s_ = 0.0;
  std::size_t heard_ = 0;
  std::size_t restarts_ = 1;                    ///< that were noted, its power-up among them
  std::array<double, hal::canards> heard_s_{};  ///< when the last pulse of each ended
  core::Microseconds imu_time_{-1}, second_imu_time_{-1}, accelerometer_time_{-1};
};

/// The content of the flash of a new board; with a plan, of one that it was sent to.
[[nodiscard]] std::vector<std::byte> new_flash();
[[nodiscard]] std::vector<std::byte> flash_with(const core::FlightPlan& plan,
                                                const hal::FlashGeometry& geometry = hal::sim::flash_16_mib);

}  // namespace fantail::board
