// SPDX-License-Identifier: MIT
#include "text/encoding.hpp"

#include <string>

#include <gtest/gtest.h>

namespace fantail::text {
namespace {

std::string wide(const std::u16string& text, bool big_endian, bool with_mark) {
  std::string bytes = with_mark ? (big_endian ? "\xFE\xFF" : "\xFF\xFE") : "";
  for (const char16_t unit : text) {
    const char low = static_cast<char>(unit & 0xFF);
    const char high = static_cast<char>(unit >> 8);
    bytes += big_endian ? high : low;
    bytes += big_endian ? low : high;
  }
  return bytes;
}

TEST(PlainText, OfUtf16InEitherOrderAndWithOrWithoutAMarkIsUtf8) {
  const std::u16string text = u"time,H\u00f6he \u20ac \U0001F680";
  const std::string ascii_first = "time,H\xC3\xB6he \xE2\x82\xAC \xF0\x9F\x9A\x80";
  for (const bool big_endian : {false, true}) {
    EXPECT_EQ(plain_text(wide(text, big_endian, true)), ascii_first);
    EXPECT_EQ(plain_text(wide(u"time,speed", big_endian, false)), "time,speed");
  }
}

TEST(PlainText, HalfACharacterIsReplaced) {
  EXPECT_EQ(plain_text("\xFF\xFE" + std::string{"a\0b", 3}), "a\xEF\xBF\xBD");
  EXPECT_EQ(plain_text(std::string{"\xFF\xFE\x3D\xD8"
                                   "a\0",
                                   6}),
            "\xEF\xBF\xBD"
            "a");
}

TEST(PlainText, HasOneNewlineAtTheEndOfALineAndNoMarkInFront) {
  EXPECT_EQ(plain_text("\xEF\xBB\xBF"
                       "a\r\nb\rc\nd\r"),
            "a\nb\nc\nd\n");
}

TEST(PlainText, LeavesOtherBytesAsTheyAre) {
  const std::string latin = "H\xF6he;1,5";
  EXPECT_EQ(plain_text(latin), latin);
  EXPECT_EQ(plain_text(""), "");
  const std::string binary{"\0\0\1\0", 4};
  EXPECT_EQ(plain_text(binary), binary);
}

}  // namespace
}  // namespace fantail::text
