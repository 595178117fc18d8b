// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "paper/paper_page.hpp"
#include "paper/print.hpp"

namespace fantail::paper {
namespace {

// The only row whose place and text hold these words.
Claim row(const std::string& place, const std::string& what) {
  std::vector<Claim> found;
  std::ranges::copy_if(print_chapter(Print::as_published()).claims, std::back_inserter(found), [&](const Claim& claim) {
    return claim.place.find(place) != std::string::npos && claim.what.find(what) != std::string::npos;
  });
  EXPECT_EQ(found.size(), 1U) << place << ": " << what;
  return found.size() == 1 ? found[0] : Claim{};
}

TEST(Print, TheWallIs200Or240MillimetresByHowTheRadiusCounts) {
  const Claim wall = row("Section 4.1", "wall");
  EXPECT_EQ(wall.kind, Kind::error_in_print);
  EXPECT_EQ(wall.ours, "200 or 240 mm");
}

TEST(Print, TheLostMinusSignsAreNamed) {
  const Claim step = row("Table 2, step 7", "Sign");
  EXPECT_EQ(step.theirs, "7.41");
  EXPECT_EQ(step.ours, "\u22127.41");
  const Claim mean = row("Table 2, mean", "Sign");
  EXPECT_EQ(mean.theirs, "6.62");
  EXPECT_EQ(mean.ours, "\u22126.62");
}

TEST(Print, HalfOfAResponseToATenthOfAHertzLasts2500Milliseconds) {
  const Claim half = row("Section 4.3.1", "First half");
  EXPECT_EQ(half.theirs, "5 s");
  EXPECT_EQ(half.ours, "2.5 s");
  EXPECT_EQ(half.kind, Kind::error_in_print);
}

TEST(Print, EachErrorInPercentNamesItsDenominator) {
  EXPECT_NE(row("Section 4.3.2", "damping, 23,").why.find("Of the launch's value; of the tunnel's it is 18.6 %"),
            std::string::npos);
  EXPECT_NE(row("Section 4.3.2", "in percent").why.find("Of the launch's value; of the tunnel's it is 19.5 %"),
            std::string::npos);
  EXPECT_NE(row("Section 4.3.2", "constant, 8,").why.find("Of the tunnel's value; of the launch's it is 20.0 %"),
            std::string::npos);
}

TEST(Print, TheSmallFiguresOfTheTextAreWorkedOut) {
  for (const auto& [place, what] :
       std::vector<std::pair<std::string, std::string>>{{"Section 4.2", "mean rate errors"},
                                                        {"Section 4.2", "Hold of the launch detection"},
                                                        {"Section 4.2", "mean angle errors"},
                                                        {"Section 5", "fin offset after burn-out"},
                                                        {"Abstract", "Smallest"},
                                                        {"Abstract", "Largest"},
                                                        {"figure 27", "Start of the second window"},
                                                        {"Section 4.3.2", "Mean offset of the launch"}}) {
    const Claim claim = row(place, what);
    EXPECT_EQ(finding(claim), "reproduced") << what;
    EXPECT_EQ(claim.kind, Kind::computed) << what;
  }
}

TEST(Print, TheSwirlIsHalfAsFarOutAsTheFinsAreWide) {
  EXPECT_EQ(row("Section 4.1.2", "Where the swirl is").ours, "50 to 150 mm");
}

TEST(Print, TheSlipsOfTheNotationAreNamed) {
  EXPECT_EQ(row("Notation", "canard commands").ours, "cmd_1, ..., cmd_4");
  EXPECT_EQ(row("Notation", "encoders").ours, "enc_1, ..., enc_4");
  EXPECT_NE(row("Notation", "OL and CL").ours.find("mean absolute errors"), std::string::npos);
  EXPECT_NE(row("Eq 22 and 23", "right-hand").theirs.find("without OL or CL"), std::string::npos);
}

TEST(Print, ContradictionsInWordsAreNamed) {
  EXPECT_EQ(row("Section 4.3.2", "offset of launch 2 was lower").ours, "for the larger ones");
  EXPECT_EQ(row("Section 4.3", "Canards of launch 2").ours, "fibreglass");
  EXPECT_EQ(row("Section 4.1.2", "back fins").ours, "of figure 8c (launch 2)");
  EXPECT_EQ(row("figure 14", "panel").ours, "14b");
}

TEST(Print, TheTrendOfTable2IsCountedRowByRow) {
  const Claim trend = row("Section 4.3.1", "lower at the begin");
  EXPECT_EQ(trend.kind, Kind::described);
  EXPECT_EQ(trend.ours, "in 7 of 8 steps");
}

// A row that is marked as computed by hand would escape the rule's test.
TEST(Print, OnlyTheListMakesComputedRows) {
  const auto claims = print_chapter(Print::as_published()).claims;
  const auto rows = static_cast<std::ptrdiff_t>(computed().size());
  const auto is_computed = [](const Claim& claim) { return claim.kind == Kind::computed; };
  EXPECT_EQ(std::count_if(claims.begin(), claims.end(), is_computed),
            std::count_if(claims.begin(), claims.begin() + rows, is_computed));
}

TEST(Print, AChangeSmallerThanTheGridsStepIsASlip) {
  EXPECT_EQ(row("Section 4.2", "Largest change of the torque").kind, Kind::error_in_print);
}

}  // namespace
}  // namespace fantail::paper
