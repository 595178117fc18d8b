// SPDX-License-Identifier: MIT
#include "sim/simulated_board.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "avionics/flight_memory.hpp"
#include "sim/inside_avionics.hpp"

namespace fantail::sim {

// Where the avionics keeps what decides about the canards, for whoever damages it.
namespace inside {

struct Law {
  using Pointer = std::optional<core::Autopilot> Avionics::*;
  friend Pointer member(Law tag);
};
template struct Open<Law, &Avionics::autopilot_>;
struct Plan {
  using Pointer = core::FlightPlan Avionics::*;
  friend Pointer member(Plan tag);
};
template struct Open<Plan, &Avionics::plan_>;

}  // namespace inside

namespace {

using core::Microseconds;

// What the firmware takes a gap for that no clock has measured; here one always has.
constexpr Microseconds assumed_gap{0};

void flip(std::span<std::byte> bytes, std::uint64_t choice) {
  const std::uint64_t bit = choice % (8 * bytes.size());
  bytes[bit / 8] ^= std::byte{1} << (bit % 8);
}

}  // namespace

SimulatedBoard::SimulatedBoard(const core::FlightPlan& plan, const BoardPorts& ports,
                               const avionics::Identity& identity)
    : plan_{plan}, ports_{ports}, identity_{identity} {
  begin();
}

void SimulatedBoard::begin() {
  devices_.arm_switch.power_up();
  devices_.abort_contact.power_up();
  hal::BackupMemory& backup_memory = ports_.has_backup_memory ? static_cast<hal::BackupMemory&>(backup_domain_)
                                                              : static_cast<hal::BackupMemory&>(no_backup_memory_);
  avionics_.emplace(avionics::Devices{.clock = devices_.clock,
                                      .imu = devices_.imu,
                                      .accelerometer = devices_.accelerometer,
                                      .servo = devices_.servo,
                                      .encoder = devices_.encoder,
                                      .arm_switch = devices_.arm_switch,
                                      .abort_contact = devices_.abort_contact,
                                      .can_bus = ports_.can_bus,
                                      .flash = ports_.flash,
                                      .console = ports_.console,
                                      .watchdog = devices_.watchdog,
                                      .entropy = ports_.entropy,
                                      .board = devices_.board,
                                      .backup_memory = backup_memory,
                                      .second_imu = &devices_.second_imu,
                                      .barometer = &devices_.barometer},
                    plan_, identity_);
}

// As firmware/boards/stm32f405/main.cpp does it.
Microseconds SimulatedBoard::restart(const Reset& reset) {
  if (reset.memory == MemoryAfterReset::lost) {
    std::ranges::fill(backup_domain_.bytes(), std::byte{0});
  }
  backup_domain_.ahead += Microseconds{std::llround(reset.clock_error_s * 1e6)};
  const Microseconds running = *backup_domain_.running_time();
  const Microseconds clock =
      avionics::clock_after_reset(backup_domain_, reset.cause, assumed_gap).value_or(Microseconds{0});
  backup_domain_.ahead = running - clock;
  devices_.world.time = clock;
  devices_.world.board.reset_cause = reset.cause;
  avionics_.reset();
  begin();
  return clock;
}

void SimulatedBoard::flip_bit(MemoryPart part, std::uint64_t choice) {
  if (part == MemoryPart::plan) {
    flip(std::as_writable_bytes(std::span{&inside::of<inside::Plan>(*avionics_), 1}), choice);
  } else {
    flip(std::as_writable_bytes(std::span{&*inside::of<inside::Law>(*avionics_), 1}), choice);
  }
}

std::unique_ptr<FlightComputer> simulated_board(const core::FlightPlan& plan, const BoardPorts& ports,
                                                const avionics::Identity& identity) {
  return std::make_unique<SimulatedBoard>(plan, ports, identity);
}

}  // namespace fantail::sim
