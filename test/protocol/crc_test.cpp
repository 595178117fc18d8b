// SPDX-License-Identifier: MIT

#include "bus_rig.hpp"
#include "protocol/crc32c.hpp"
#include "protocol/crc8.hpp"
#include "test.hpp"

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

TEST(Crc8, GivesTheCheckValueOfItsCatalogueEntry) {
  constexpr std::string_view text = "123456789";
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  EXPECT_EQ(crc8_autosar(bytes), 0xDF);
  EXPECT_EQ(naive_crc8(bytes), 0xDF);
}

// The table in the AUTOSAR specification of CRC routines, section on the polynomial 0x2F.
TEST(Crc8, GivesTheTestVectorsOfAutosar) {
  const auto crc = [](std::vector<std::uint8_t> bytes) { return crc8_autosar(bytes); };
  EXPECT_EQ(crc({0x00, 0x00, 0x00, 0x00}), 0x12);
  EXPECT_EQ(crc({0xF2, 0x01, 0x83}), 0xC2);
  EXPECT_EQ(crc({0x0F, 0xAA, 0x00, 0x55}), 0xC6);
  EXPECT_EQ(crc({0x00, 0xFF, 0x55, 0x11}), 0x77);
  EXPECT_EQ(crc({0x33, 0x22, 0x55, 0xAA, 0xBB, 0xCC, 0xDD, 0xEE, 0xFF}), 0x11);
  EXPECT_EQ(crc({0x92, 0x6B, 0x55}), 0x33);
  EXPECT_EQ(crc({0xFF, 0xFF, 0xFF, 0xFF}), 0x6C);
}

TEST(Crc8, EqualsTheDivisionBitByBitForEveryByteAndPlace) {
  for (unsigned place = 0; place < 9; ++place) {
    for (unsigned value = 0; value < 256; ++value) {
      std::vector<std::uint8_t> bytes(9, 0xA5);
      bytes[place] = static_cast<std::uint8_t>(value);
      ASSERT_EQ(crc8_autosar(bytes), naive_crc8(bytes));
    }
  }
}

}  // namespace

}  // namespace fantail::protocol
