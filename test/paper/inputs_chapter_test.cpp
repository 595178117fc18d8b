// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "paper/paper_page.hpp"

namespace fantail::paper {
namespace {

TEST(Inputs, TheShippedFilesHoldWhatIsPrinted) {
  for (const Claim& claim : inputs_chapter().claims) {
    EXPECT_TRUE(claim.agrees) << claim.place << ": " << claim.what << ": " << claim.theirs << " / " << claim.ours;
    EXPECT_FALSE(counts_as_reproduced(claim.kind)) << claim.what;
  }
}

TEST(Inputs, EachRowOfTable1IsThere) {
  const auto chapter = inputs_chapter();
  EXPECT_EQ(std::ranges::count_if(chapter.claims, [](const Claim& claim) { return claim.place == "Table 1"; }), 4);
}

TEST(Inputs, TheExcitationSaysWhatItsFormMeans) {
  const auto chapter = inputs_chapter();
  const auto row =
      std::ranges::find_if(chapter.claims, [](const Claim& claim) { return claim.place == "Eq 45 and 46, figure 26"; });
  ASSERT_NE(row, chapter.claims.end());
  EXPECT_NE(row->why.find("|4t \u2212 10| Hz: 8.4 at 0.4 s, zero at 2.5 s, 18 at 7 s"), std::string::npos) << row->why;
}

}  // namespace
}  // namespace fantail::paper
