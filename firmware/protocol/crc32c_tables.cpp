// SPDX-License-Identifier: MIT
#include <array>

#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"

namespace fantail::protocol {
namespace {

using Table = std::array<std::uint32_t, 256>;

// Four bytes at a time (Kounavis and Berry, "slicing by 4"): a table for each, of what byte b does to the remainder
// when so many more bytes follow it. Eight would be faster still, but their 8 kB are an eighth of the flight image.
// Four arrays and not one: within one the Cortex-M4 would add up each address by itself.
constexpr Table last = [] {
  Table table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) {
      value = (value & 1U) != 0U ? (value >> 1U) ^ 0x82F63B78U : value >> 1U;
    }
    table[i] = value;
  }
  return table;
}();

constexpr Table one_earlier(const Table& table) {
  Table result{};
  for (std::size_t i = 0; i < 256; ++i) {
    result[i] = last[table[i] & 0xFFU] ^ (table[i] >> 8U);
  }
  return result;
}

constexpr Table third = one_earlier(last);
constexpr Table second = one_earlier(third);
constexpr Table first = one_earlier(second);

}  // namespace

std::uint32_t crc32c(std::span<const std::byte> bytes) { return crc32c(0, bytes); }

std::uint32_t crc32c(std::uint32_t before, std::span<const std::byte> bytes) {
  std::uint32_t crc = ~before;
  const auto words = bytes.first(bytes.size() / 4 * 4);
  for (const std::byte* at = words.data(); at != words.data() + words.size(); at += 4) {
    const auto word = static_cast<std::uint32_t>(get<4>({at, 4}, 0)) ^ crc;
    crc = first[word & 0xFFU] ^ second[(word >> 8U) & 0xFFU] ^ third[(word >> 16U) & 0xFFU] ^ last[word >> 24U];
  }
  for (const std::byte byte : bytes.subspan(words.size())) {
    crc = last[(crc ^ static_cast<std::uint32_t>(byte)) & 0xFFU] ^ (crc >> 8U);
  }
  return ~crc;
}

}  // namespace fantail::protocol
