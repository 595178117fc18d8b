// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace fantail::protocol {

namespace crc8 {

inline constexpr auto table = [] {
  std::array<std::uint8_t, 256> result{};
  for (std::uint32_t i = 0; i < result.size(); ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) {
      value = (value & 0x80U) != 0U ? (value << 1U) ^ 0x2FU : value << 1U;
    }
    result[i] = static_cast<std::uint8_t>(value);
  }
  return result;
}();

}  // namespace crc8

/// CRC-8/AUTOSAR (polynomial 0x2F, not reflected, start and final xor of all ones). "123456789" -> 0xDF. Finds every
/// error of up to three bits, and every burst of up to eight, in up to 119 bits: a frame of the bus has 80.
class Crc8Autosar {
 public:
  /// The lowest eight bits.
  constexpr void add(std::uint32_t byte) { state_ = crc8::table[(state_ ^ byte) & 0xFFU]; }
  [[nodiscard]] constexpr std::uint8_t result() const { return static_cast<std::uint8_t>(~state_ & 0xFFU); }

 private:
  std::uint32_t state_ = 0xFF;
};

[[nodiscard]] constexpr std::uint8_t crc8_autosar(std::span<const std::uint8_t> bytes) {
  Crc8Autosar crc;
  for (const std::uint8_t byte : bytes) {
    crc.add(byte);
  }
  return crc.result();
}

}  // namespace fantail::protocol
