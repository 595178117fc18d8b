// SPDX-License-Identifier: MIT
#include "protocol/bus_codec.hpp"

namespace fantail::protocol {

std::optional<std::uint8_t> Sequence::lost_before(std::uint8_t counter) {
  const std::uint8_t now = counter & 0x0FU;
  const std::uint8_t expected = last_ ? (*last_ + 1U) & 0x0FU : now;
  last_ = now;
  const std::uint8_t lost = static_cast<std::uint8_t>(now - expected) & 0x0FU;
  constexpr std::uint8_t once_around = 15;
  return lost == once_around ? std::nullopt : std::optional{lost};
}

}  // namespace fantail::protocol
