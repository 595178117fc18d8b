// SPDX-License-Identifier: MIT
// card.png, as fly and report draw it.
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "system/folder.hpp"
#include "system/process.hpp"

namespace fantail::test {
namespace {

bool has_card_program() { return std::system("command -v rsvg-convert > /dev/null") == 0; }

// Bytes 16 to 23 of a PNG file are its width and height.
TEST(Card, IsDrawnWhenItIsAskedForAndTakesAnOldOneAwayWhenNot) {
  if (!has_card_program()) {
    GTEST_SKIP() << "the package librsvg2-bin is not installed";
  }
  const Folder folder;
  const Outcome outcome = fantail({"fly", "--card", "--out", folder / "out"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("out/card.png"), std::string::npos) << outcome.out;
  const std::string png = content(folder / "out/card.png");
  ASSERT_GT(png.size(), 10'000U);
  EXPECT_EQ(png.substr(16, 8), (std::string{"\0\0\x04\xb0\0\0\x02\x76", 8}));  // 1200 x 630
  EXPECT_EQ(fantail({"report", folder / "out", "--card", "--out", folder / "again"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "again/card.png"));
  EXPECT_EQ(fantail({"fly", "--out", folder / "out"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/card.png"));
}

TEST(Card, ThatNothingDrawsIsSaidWithItsPackageBeforeTheFlight) {
  const Folder folder;
  const Outcome outcome =
      fantail({"fly", "--card", "--out", folder / "out"}, {.prepare = [] { ::setenv("PATH", "/nowhere", 1); }});
  EXPECT_EQ(outcome.exit_code, 74);
  EXPECT_NE(outcome.err.find("librsvg2-bin"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  EXPECT_EQ(fantail({"report", "a.csv", "b.csv", "--card"}).exit_code, 64);
}

}  // namespace
}  // namespace fantail::test
