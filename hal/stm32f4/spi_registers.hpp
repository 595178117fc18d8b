// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hal/stm32f4/spi_bus.hpp"

namespace fantail::hal::stm32f4 {

/// The byte-wide registers of a sensor: an address with a bit that says "read", then the content, with addresses that
/// count up by themselves.
class SpiRegisters {
 public:
  explicit SpiRegisters(SpiDevice device) : device_{device} {}

  bool write(std::uint8_t address, std::uint8_t value);
  bool read(std::uint8_t address, std::span<std::byte> out);
  std::optional<std::uint8_t> read(std::uint8_t address);

 private:
  SpiDevice device_;
};

}  // namespace fantail::hal::stm32f4
