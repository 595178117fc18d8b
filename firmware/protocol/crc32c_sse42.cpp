// SPDX-License-Identifier: MIT
// Eight bytes an instruction, where every PC that Fantail is built for has it.
#include <nmmintrin.h>

#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"

namespace fantail::protocol {

std::uint32_t crc32c(std::span<const std::byte> bytes) { return crc32c(0, bytes); }

std::uint32_t crc32c(std::uint32_t before, std::span<const std::byte> bytes) {
  std::uint64_t crc = ~before;
  for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
    crc = _mm_crc32_u64(crc, get<8>(bytes, 0));
  }
  auto last = static_cast<std::uint32_t>(crc);
  for (const std::byte byte : bytes) {
    last = _mm_crc32_u8(last, static_cast<std::uint8_t>(byte));
  }
  return ~last;
}

}  // namespace fantail::protocol
