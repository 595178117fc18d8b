// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fantail::protocol {

/// CRC-32C (Castagnoli: reflected, polynomial 0x1EDC6F41, start and final xor of all ones). "123456789" -> 0xE3069283.
[[nodiscard]] std::uint32_t crc32c(std::span<const std::byte> bytes);

}  // namespace fantail::protocol
