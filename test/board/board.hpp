// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "address_space.hpp"
#include "chip.hpp"
#include "elf.hpp"
#include "fake_as5047p.hpp"
#include "fake_icm42688.hpp"
#include "fake_ism330dhcx.hpp"
#include "fake_kx134.hpp"
#include "fake_ms5611.hpp"
#include "fake_w25q.hpp"
#include "hal/can_bus.hpp"
#include "processor.hpp"
#include "system_block.hpp"
#include "timeline.hpp"

namespace fantail::board {

/// The flight computer as docs/hardware.md wires it, with the image that is flashed on it: processor, chip, sensors,
/// encoders, flash, transceiver, switches, battery. It runs by itself; who holds it lets time pass and looks at its
/// pins.
class Board {
 public:
  Board(const Image& image, const Pace& pace);
  Board(const Board&) = delete;  // all its parts point to each other
  Board& operator=(const Board&) = delete;

  /// The supply comes.
  void switch_on();
  /// Something else begins the processor anew.
  void reset(ResetKind kind);
  /// The crystal stops, or may start again; one that stops is missed at once.
  void set_crystal(bool runs);
  /// Lets time pass until then, or until stop().
  void run_until(double time_s);
  void stop() { stopped_ = true, processor.stop(); }
  [[nodiscard]] double now_s() const { return timeline.now_s(); }

  // ---- the bus ----
  /// More would only wait: the bus is busy with what has been sent for the next millisecond.
  [[nodiscard]] bool bus_is_full() const { return arriving_.size() >= 8; }
  /// From another node; it comes in one after the other.
  void send(const hal::CanFrame& frame) { arriving_.push_back(frame); }
  /// What this node has sent since this was asked last.
  [[nodiscard]] std::vector<hal::CanFrame> take_sent();
  struct Passed {
    double time_s;
    hal::CanFrame frame;
  };
  /// All that went over the bus, of both sides.
  std::vector<Passed> traffic{};

  // ---- what it shows ----
  /// All that has left the console.
  std::string console{};
  struct Restart {
    double time_s;
    ResetKind kind;
  };
  std::vector<Restart> restarts{};
  /// What a driver did that a device forbids: everything so far, each once.
  [[nodiscard]] std::vector<std::string> violations() const;
  /// For who waits in vain: where the processor is, what it complained of first, what the console said.
  [[nodiscard]] std::string state(const Image& image) const;

  Timeline timeline;

 private:
  AddressSpace space_;

 public:
  Chip chip;
  SystemBlock system;
  Processor processor;

  // ---- what else is soldered to it ----
  devices::FakeIcm42688 imu;
  devices::FakeIsm330dhcx second_imu;
  devices::FakeKx134 accelerometer;
  devices::FakeMs5611 barometer;
  std::array<devices::FakeAs5047p, 4> encoders{};
  devices::FakeW25q flash;
  double battery_v = 12.0;
  bool arm_switch_closed = false;
  bool abort_contact_closed = false;
  /// What the processor reaches instead of this device; empty: itself. See connect().
  std::function<devices::SpiSlave&(devices::SpiSlave& device)> wire{};
  /// Wires all devices to the processor, as after every reset.
  void connect();

 private:
  void begin(ResetKind kind);
  void follow();
  void pass_slot();
  void pass_byte();

  Timeline::Event follow_;
  Timeline::Event slot_;
  Timeline::Event byte_;
  Timeline::Event stop_;
  std::deque<hal::CanFrame> arriving_;
  std::vector<hal::CanFrame> sent_;
  bool own_turn_ = false;
  bool crystal_is_missed_ = false;
  std::optional<ResetKind> reset_asked_;
  bool stopped_ = false;
  std::vector<std::string> old_violations_;
};

}  // namespace fantail::board
