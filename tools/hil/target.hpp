// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/time.hpp"
#include "hil/wire.hpp"
#include "protocol/hil_frame.hpp"
#include "sim/flight_computer.hpp"
#include "world_link/exchange.hpp"

namespace fantail::hil {

/// Called a few times a second while nothing comes. What it throws ends the waiting.
using Waiting = std::function<void()>;

struct Timeouts {
  std::chrono::milliseconds send_again{250};
  std::chrono::milliseconds give_up{5'000};
};

/// The world's side of the link (protocol/hil_frame.hpp): it asks, and waits for the answer.
class Link {
 public:
  explicit Link(std::unique_ptr<Wire> wire, Waiting waiting = {}, const Timeouts& timeouts = {})
      : wire_{std::move(wire)}, waiting_{std::move(waiting)}, timeouts_{timeouts} {}

  /// Where the payload of the next question goes.
  [[nodiscard]] std::span<std::byte> payload() { return out_.payload(); }
  /// Its payload is valid until the next call. Throws TargetError when no answer came in time.
  [[nodiscard]] protocol::LogFrame ask(protocol::HilType type, std::size_t payload_size, core::Microseconds time = {});

  /// Questions that were asked more than once, since either was damaged on its way, they or the answer.
  [[nodiscard]] std::uint32_t asked_again() const { return asked_again_; }
  /// Of the frames that came, those that were damaged.
  [[nodiscard]] std::uint32_t damaged() const { return in_.damaged(); }

 private:
  [[noreturn]] void give_up(std::uint32_t damaged_frames) const;

  std::unique_ptr<Wire> wire_;
  Waiting waiting_;
  Timeouts timeouts_;
  protocol::HilFrameIn in_;
  protocol::HilFrameOut out_;
  std::uint32_t sequence_ = 0;
  std::uint32_t asked_again_ = 0;
};

/// The identity of a flight computer.
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
  /// Throws TargetError without an answer, and text::Error if the answer is of another version of the link.
  explicit Target(std::unique_ptr<Wire> wire, Waiting waiting = {}, const Timeouts& timeouts = {});

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
  /// Throws TargetError: it cannot be reset from here.
  core::Microseconds restart(const sim::Reset& reset) override;

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
