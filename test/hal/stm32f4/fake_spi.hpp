// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hal/stm32f4/registers/gpio.hpp"
#include "hal/stm32f4/registers/spi.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4::test {

/// A port whose outputs somebody watches. All pins are high at first, as the pin map leaves chip selects.
class FakePort {
 public:
  using Watcher = std::function<void(bool level)>;

  explicit FakePort(RegisterWorld& world);
  registers::Gpio& block() { return block_; }
  void watch(std::uint8_t pin, Watcher watcher) { watchers_[pin] = std::move(watcher); }

 private:
  registers::Gpio block_{};
  std::uint32_t level_ = 0xFFFF;
  std::map<std::uint8_t, Watcher> watchers_;
};

/// A device on an SPI bus, byte by byte.
class SpiSlave {
 public:
  struct Needs {
    std::vector<std::uint8_t> modes;  ///< those it understands
    std::uint32_t most_hz;
    std::uint32_t select_ns = 0;  ///< between chip select and the first clock
  };

  virtual ~SpiSlave() = default;
  [[nodiscard]] virtual Needs needs() const = 0;
  virtual void selected() = 0;
  virtual std::uint8_t exchange(std::uint8_t out) = 0;
  virtual void deselected() = 0;
};

/// An SPI block as RM0090 section 28.3 describes it: transmit buffer, shift register, receive buffer, and what happens
/// when they are not looked after. What a driver must not do is written down in `violations`.
class FakeSpi {
 public:
  /// Clocks of its bus since power-up.
  using BusClocks = std::function<std::uint64_t()>;

  /// Without `clocks` its time goes by in looks at SR, a few for each byte.
  FakeSpi(RegisterWorld& world, std::uint32_t bus_hz, BusClocks clocks = {});
  registers::Spi& block() { return block_; }

  /// The slave outlives this object. Its chip select is low when it is selected.
  void attach(FakePort& port, std::uint8_t pin, SpiSlave& slave);

  // ---- faults ----
  /// From now on no byte ever comes to its end.
  void stop() { stopped_ = true; }
  void go_on() { stopped_ = false; }
  /// Behind every byte that is written an interrupt takes as long as so many looks.
  void interrupt_for(int looks) { interrupt_looks_ = looks; }

  /// Called when a byte has gone over the wire, without `clocks`: for a clock that goes on meanwhile.
  std::function<void()> on_byte{};

  // ---- what was seen ----
  std::vector<std::string> violations{};
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  /// Eight clocks of the wire for each byte.
  [[nodiscard]] double wire_us() const { return wire_us_; }
  [[nodiscard]] std::uint32_t clock_hz() const;
  [[nodiscard]] std::uint64_t looks() const { return looks_; }
  void forget_traffic() { bytes_ = 0, wire_us_ = 0.0; }

 private:
  std::uint32_t look();
  [[nodiscard]] std::uint64_t now() const { return clocks_ ? clocks_() : looks_; }
  void follow();
  [[nodiscard]] bool is_busy() const { return shifting_ || now() < idle_at_; }
  void write_control(std::uint32_t value);
  void write_data(std::uint32_t value);
  std::uint32_t read_data();
  void begin(std::uint8_t out, std::uint64_t at);
  void select(SpiSlave& slave, bool level);

  registers::Spi block_{};
  std::uint32_t bus_hz_;
  std::uint32_t control_ = 0;
  std::vector<SpiSlave*> selected_;
  std::optional<std::uint8_t> shifting_;  ///< what will have been received at ends_at_
  std::optional<std::uint8_t> waiting_;   ///< in the transmit buffer
  std::uint8_t received_ = 0;
  bool full_ = false;
  bool overrun_ = false;
  bool data_was_read_ = false;
  std::uint64_t ends_at_ = 0;
  std::uint64_t idle_at_ = 0;  ///< the last edge behind what has ended
  BusClocks clocks_;
  std::uint64_t looks_ = 0;
  std::uint64_t selected_at_ = 0;
  bool clocked_ = false;
  bool stopped_ = false;
  int interrupt_looks_ = 0;
  std::uint64_t bytes_ = 0;
  double wire_us_ = 0.0;
};

}  // namespace fantail::hal::stm32f4::test
