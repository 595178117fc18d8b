// SPDX-License-Identifier: MIT
#include "protocol/crc32c.hpp"

#include <array>
#include <string_view>

#include <gtest/gtest.h>

namespace fantail::protocol {
namespace {

std::uint32_t crc_of(std::string_view text) { return crc32c(std::as_bytes(std::span{text})); }

TEST(Crc32c, GivesTheCheckValueOfItsCatalogueEntry) {
  EXPECT_EQ(crc_of("123456789"), 0xE3069283U);
  EXPECT_EQ(crc_of(""), 0U);
}

// The test vectors of RFC 3720, appendix B.4.
TEST(Crc32c, GivesTheTestVectorsOfIscsi) {
  std::array<std::byte, 32> bytes{};
  EXPECT_EQ(crc32c(bytes), 0x8A9136AAU);
  bytes.fill(std::byte{0xFF});
  EXPECT_EQ(crc32c(bytes), 0x62A8AB43U);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<std::byte>(i);
  }
  EXPECT_EQ(crc32c(bytes), 0x46DD794EU);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<std::byte>(31 - i);
  }
  EXPECT_EQ(crc32c(bytes), 0x113FDB5CU);
}

TEST(Crc32c, OfPartsIsThatOfTheWhole) {
  const std::string_view text = "123456789 and some more, so that eight bytes at a time do not suffice";
  const auto bytes = std::as_bytes(std::span{text});
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    EXPECT_EQ(crc32c(crc32c(bytes.first(cut)), bytes.subspan(cut)), crc32c(bytes));
  }
}

// One bit at a time, as the polynomial is defined.
std::uint32_t slow_crc(std::span<const std::byte> bytes) {
  std::uint32_t crc = ~0U;
  for (const std::byte byte : bytes) {
    crc ^= std::to_integer<std::uint32_t>(byte);
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc & 1U) != 0 ? (crc >> 1U) ^ 0x82F63B78U : crc >> 1U;
    }
  }
  return ~crc;
}

TEST(Crc32c, IsThatOfItsDefinitionForEveryLengthAndEveryValue) {
  std::array<std::byte, 600> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<std::byte>(i * 167 + i / 256);
  }
  for (std::size_t length = 0; length <= bytes.size(); ++length) {
    const auto part = std::span{bytes}.last(length);
    EXPECT_EQ(crc32c(part), slow_crc(part));
  }
}

}  // namespace
}  // namespace fantail::protocol
