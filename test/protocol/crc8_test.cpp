// SPDX-License-Identifier: MIT
#include "protocol/crc8.hpp"

#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "bus_rig.hpp"

namespace fantail::protocol {
namespace {

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
