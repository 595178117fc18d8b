// SPDX-License-Identifier: MIT
#include "files/mat_writer.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fantail::files {
namespace {

// Behind 8 bytes of tag, 16 of class, 16 of size and 8 of an empty name: a tag, and two bytes a unit.
std::u16string units(const std::string& array) {
  std::u16string all;
  for (std::size_t at = 56; at + 1 < array.size() && all.size() < static_cast<std::size_t>(array[36]); at += 2) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(array[i]); };
    all += static_cast<char16_t>(byte(at) | byte(at + 1) << 8U);
  }
  return all;
}

TEST(MatWriter, HasTextsInUtf16) { EXPECT_EQ(units(mat::text("a\u00E9\u20AC\U0001F680")), u"a\u00E9\u20AC\U0001F680"); }

TEST(MatWriter, HasAReplacementForEachByteThatIsNoUtf8) {
  EXPECT_EQ(units(mat::text("a\xFFz")), u"a\uFFFDz");
  EXPECT_EQ(units(mat::text("\xC3")), u"\uFFFD") << "cut off";
  EXPECT_EQ(units(mat::text("\xC0\xAF")), u"\uFFFD\uFFFD") << "longer than it must be";
  EXPECT_EQ(units(mat::text("\xED\xA0\x80")), u"\uFFFD\uFFFD\uFFFD") << "half of a pair";
}

TEST(MatWriter, GivesTheSameBytesForTheSameArrays) {
  const std::vector<std::string> arrays{mat::column(std::vector{1.0, 2.0}, "time_s")};
  EXPECT_EQ(mat::file(arrays), mat::file(arrays));
  EXPECT_TRUE(mat::file(arrays).starts_with("MATLAB 5.0 MAT-file"));
}

}  // namespace
}  // namespace fantail::files
