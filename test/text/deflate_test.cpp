// SPDX-License-Identifier: MIT
#include "text/deflate.hpp"

#include <string>

#include <gtest/gtest.h>

namespace fantail::text {
namespace {

TEST(Gzip, GivesTheTextsOfAllMembersBackAndNothingOfADamagedFile) {
  const std::string long_text(200'000, 'x');
  EXPECT_TRUE(gunzip(gzip("run,seed\n") + gzip(long_text) + gzip("")) == "run,seed\n" + long_text);
  const std::string text = "17,4711,0.25,held\n18,4712,0.75,not_held\n";
  const std::string bytes = gzip(text);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_EQ(gunzip(bytes.substr(0, length)), std::nullopt) << length;
  }
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    const auto read = gunzip(damaged);
    EXPECT_TRUE(!read || *read == text) << bit << ": bits that mean nothing may change, no text";
  }
}

TEST(Zlib, GivesATextBackAndNothingOfOneThatIsDamagedOrTooLong) {
  const std::string text = "17,4711,0.25,held\n18,4712,0.75,not_held\n";
  const std::string bytes = zlib_packed(text);
  EXPECT_EQ(zlib_unpacked(bytes, text.size()), text);
  EXPECT_EQ(zlib_unpacked(bytes, text.size() - 1), std::nullopt);
  EXPECT_EQ(zlib_unpacked(bytes + bytes, 1000), std::nullopt) << "only one in a row";
  EXPECT_EQ(zlib_unpacked(gzip(text), 1000), std::nullopt) << "the other format";
  EXPECT_EQ(gunzip(gzip(std::string(1'000'000, 'x')), 999'999), std::nullopt);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_EQ(zlib_unpacked(bytes.substr(0, length), 1000), std::nullopt) << length;
  }
}

// The check value of the algorithm's catalogue entry, CRC-32/ISO-HDLC.
TEST(Crc32, IsThatOfTheStandard) { EXPECT_EQ(crc32("123456789"), 0xCBF43926U); }

}  // namespace
}  // namespace fantail::text
