// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace fantail::protocol {

/// CRC-8/AUTOSAR (polynomial 0x2F, not reflected, start and final xor of all ones). "123456789" -> 0xDF. Finds every
/// error of up to three bits, and every burst of up to eight, in up to 119 bits: a frame of the bus has 80.
[[nodiscard]] std::uint8_t crc8_autosar(std::span<const std::uint8_t> bytes);

}  // namespace fantail::protocol
