// SPDX-License-Identifier: MIT
#include "table_file/utf16.hpp"

#include <gtest/gtest.h>

namespace fantail::table_file {
namespace {

TEST(Utf16, IsTheSameTextThereAndBack) {
  EXPECT_EQ(utf16("Tasha \xC3\xA9\xE2\x82\xAC\xF0\x9F\x9A\x80"), u"Tasha \u00E9\u20AC\U0001F680");
  EXPECT_EQ(utf8(u"Tasha \u00E9\u20AC\U0001F680"), "Tasha \xC3\xA9\xE2\x82\xAC\xF0\x9F\x9A\x80");
}

TEST(Utf16, ReplacesWhatIsNoText) {
  EXPECT_EQ(utf16("a\xFF\x80z"), u"a\uFFFD\uFFFDz");
  EXPECT_EQ(utf16("\xC3"), u"\uFFFD") << "cut off";
  EXPECT_EQ(utf16("\xC0\xAF"), u"\uFFFD\uFFFD") << "longer than it must be";
  EXPECT_EQ(utf16("\xED\xA0\x80"), u"\uFFFD\uFFFD\uFFFD") << "half of a pair";
  const std::u16string half{static_cast<char16_t>(0xD83D), u'x'};
  EXPECT_EQ(utf8(half), "\xEF\xBF\xBDx");
}

}  // namespace
}  // namespace fantail::table_file
