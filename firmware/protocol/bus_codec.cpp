// SPDX-License-Identifier: MIT
#include "protocol/bus_codec.hpp"

#include <array>

#include "protocol/crc8.hpp"

namespace fantail::protocol {
namespace {

// Meets BEN-7.
std::uint8_t crc_of(std::uint16_t session) {
  return crc8_autosar(std::array{static_cast<std::uint8_t>(session & 0xFFU), static_cast<std::uint8_t>(session >> 8U)});
}

}  // namespace

// A CRC is linear: what follows the numbers adds the same to both.
bool told_apart(std::uint16_t session, std::uint16_t other) { return crc_of(session) != crc_of(other); }

// Meets BUS-2.
std::optional<std::uint8_t> Sequence::lost_before(std::uint8_t counter) {
  const std::uint8_t now = counter & 0x0FU;
  const std::uint8_t expected = last_ ? (*last_ + 1U) & 0x0FU : now;
  last_ = now;
  const std::uint8_t lost = static_cast<std::uint8_t>(now - expected) & 0x0FU;
  constexpr std::uint8_t once_around = 15;
  return lost == once_around ? std::nullopt : std::optional{lost};
}

}  // namespace fantail::protocol
