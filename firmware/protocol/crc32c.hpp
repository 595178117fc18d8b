// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fantail::protocol {

/// CRC-32C (Castagnoli: reflected, polynomial 0x1EDC6F41, start and final xor of all ones). "123456789" -> 0xE3069283.
[[nodiscard]] std::uint32_t crc32c(std::span<const std::byte> bytes);

/// The same of bytes that come in parts: `before` is the CRC of the parts so far, 0 of none.
[[nodiscard]] std::uint32_t crc32c(std::uint32_t before, std::span<const std::byte> bytes);

}  // namespace fantail::protocol
