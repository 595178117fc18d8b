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

}  // namespace
}  // namespace fantail::protocol
