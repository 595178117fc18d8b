// SPDX-License-Identifier: MIT
#include <array>

#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"

namespace fantail::protocol {
namespace {

using Table = std::array<std::uint32_t, 256>;

// Four bytes at a time (Kounavis and Berry, "slicing by 4"): tables[k][b] is what byte b does to the remainder when k
// more bytes follow it. Eight would be faster still, but their 8 kB are an eighth of the flight image.
constexpr std::array<Table, 4> make_tables() {
  std::array<Table, 4> tables{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) {
      value = (value & 1U) != 0U ? (value >> 1U) ^ 0x82F63B78U : value >> 1U;
    }
    tables[0][i] = value;
  }
  for (std::size_t k = 1; k < tables.size(); ++k) {
    for (std::size_t i = 0; i < 256; ++i) {
      const std::uint32_t before = tables[k - 1][i];
      tables[k][i] = tables[0][before & 0xFFU] ^ (before >> 8U);
    }
  }
  return tables;
}

constexpr auto tables = make_tables();

}  // namespace

std::uint32_t crc32c(std::span<const std::byte> bytes) { return crc32c(0, bytes); }

std::uint32_t crc32c(std::uint32_t before, std::span<const std::byte> bytes) {
  std::uint32_t crc = ~before;
  for (; bytes.size() >= 4; bytes = bytes.subspan(4)) {
    const auto word = static_cast<std::uint32_t>(get<4>(bytes, 0)) ^ crc;
    crc = tables[3][word & 0xFFU] ^ tables[2][(word >> 8U) & 0xFFU] ^ tables[1][(word >> 16U) & 0xFFU] ^
          tables[0][word >> 24U];
  }
  for (const std::byte byte : bytes) {
    crc = tables[0][(crc ^ static_cast<std::uint32_t>(byte)) & 0xFFU] ^ (crc >> 8U);
  }
  return ~crc;
}

}  // namespace fantail::protocol
