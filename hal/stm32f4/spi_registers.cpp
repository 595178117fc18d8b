// SPDX-License-Identifier: MIT
#include "hal/stm32f4/spi_registers.hpp"

#include <array>

namespace fantail::hal::stm32f4 {

bool SpiRegisters::write(std::uint8_t address, std::uint8_t value) {
  return device_.transfer(std::array{std::byte{address}, std::byte{value}}, {});
}

bool SpiRegisters::read(std::uint8_t address, std::span<std::byte> out) {
  const std::array command{std::byte{address} | std::byte{0x80}};
  return device_.transfer({{.out = command}, {.in = out}});
}

std::optional<std::uint8_t> SpiRegisters::read(std::uint8_t address) {
  std::array<std::byte, 1> value{};
  return read(address, value) ? std::optional{std::to_integer<std::uint8_t>(value[0])} : std::nullopt;
}

}  // namespace fantail::hal::stm32f4
