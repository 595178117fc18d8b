// SPDX-License-Identifier: MIT
#include "protocol/crc8.hpp"

#include <array>

namespace fantail::protocol {
namespace {

constexpr std::array<std::uint8_t, 256> make_table() {
  std::array<std::uint8_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) {
      value = (value & 0x80U) != 0U ? (value << 1U) ^ 0x2FU : value << 1U;
    }
    table[i] = static_cast<std::uint8_t>(value);
  }
  return table;
}

constexpr auto table = make_table();

}  // namespace

std::uint8_t crc8_autosar(std::span<const std::uint8_t> bytes) {
  std::uint8_t crc = 0xFF;
  for (const std::uint8_t byte : bytes) {
    crc = table[static_cast<std::uint8_t>(crc ^ byte)];
  }
  return static_cast<std::uint8_t>(crc ^ 0xFFU);
}

}  // namespace fantail::protocol
