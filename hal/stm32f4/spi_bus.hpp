// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>

#include "hal/stm32f4/pin.hpp"
#include "hal/stm32f4/registers/spi.hpp"

namespace fantail::hal::stm32f4 {

/// Which edge of the clock takes a bit, in the numbers that data sheets use.
enum class SpiMode : std::uint8_t {
  mode_0,  ///< idle low, taken at the rising edge
  mode_1,  ///< idle low, taken at the falling edge
  mode_2,  ///< idle high, taken at the falling edge
  mode_3,  ///< idle high, taken at the rising edge
};

/// What a device asks of the bus.
struct SpiSettings {
  SpiMode mode = SpiMode::mode_0;
  std::uint32_t most_hz = 0;    ///< its fastest clock
  std::uint32_t select_ns = 0;  ///< it wants to be selected for so long before the first edge of the clock
};

/// One stretch of a transfer, as long as the longer of the two: behind the end of `out` zeros are sent, and what is
/// received behind the end of `in` is dropped.
struct SpiSegment {
  std::span<const std::byte> out{};
  std::span<std::byte> in{};
};

/// One SPI block as a full-duplex master of 8-bit frames. It is polled: a transfer of a tick takes some microseconds,
/// less than an interrupt for each byte would. Every wait ends.
class SpiBus {
 public:
  /// The bus clock is the one the block runs on: APB2 for SPI1, APB1 for SPI2 and SPI3. The block outlives this object,
  /// and its clock and pins are switched on before the first transfer.
  SpiBus(registers::Spi& block, std::uint32_t bus_hz) : block_{block}, bus_hz_{bus_hz} {}

  /// Selects, transfers all segments, waits until the last bit has left, and deselects. False when the block did not
  /// do its part in time; what was received is then worth nothing.
  bool transfer(const SpiSettings& settings, Pin& select, std::span<const SpiSegment> segments);

  /// What this bus runs at for a device: the fastest clock that is not above the device's, or the slowest there is.
  [[nodiscard]] std::uint32_t clock_hz(const SpiSettings& settings) const;

 private:
  [[nodiscard]] std::uint32_t prescaler(const SpiSettings& settings) const;
  bool prepare(const SpiSettings& settings);
  bool send(std::span<const std::byte> out);
  bool exchange(const SpiSegment& segment);
  void drop_received();

  registers::Spi& block_;
  std::uint32_t bus_hz_;
  std::optional<std::uint32_t> control_;  ///< CR1, as it was written last
  std::uint32_t most_looks_ = 0;
};

/// One device on a bus that others may share.
class SpiDevice {
 public:
  /// The bus outlives this object. Nothing is selected until the first transfer: the pin map drives the pin high.
  SpiDevice(SpiBus& bus, Pin select, const SpiSettings& settings) : bus_{&bus}, select_{select}, settings_{settings} {}

  bool transfer(std::span<const std::byte> out, std::span<std::byte> in) { return transfer({SpiSegment{out, in}}); }
  /// Several segments under one chip select.
  bool transfer(std::initializer_list<SpiSegment> segments) {
    return bus_->transfer(settings_, select_, {segments.begin(), segments.size()});
  }

 private:
  SpiBus* bus_;
  Pin select_;
  SpiSettings settings_;
};

}  // namespace fantail::hal::stm32f4
