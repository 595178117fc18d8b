// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "paper/chapters.hpp"

namespace fantail::paper {
namespace {

// The only row whose place and text hold these words.
Claim row(const std::string& place, const std::string& what) {
  std::vector<Claim> found;
  std::ranges::copy_if(print_chapter().claims, std::back_inserter(found), [&](const Claim& claim) {
    return claim.place.find(place) != std::string::npos && claim.what.find(what) != std::string::npos;
  });
  EXPECT_EQ(found.size(), 1U) << place << ": " << what;
  return found.size() == 1 ? found[0] : Claim{};
}

TEST(Print, TheWallIs200Or240MillimetresByHowTheRadiusCounts) {
  const Claim wall = row("Section 4.1", "wall");
  EXPECT_EQ(wall.finding, Finding::error_in_print);
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
  EXPECT_EQ(half.finding, Finding::error_in_print);
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
                                                        {"Section 4.2", "mean angle errors"},
                                                        {"Section 5", "fin offset after burn-out"},
                                                        {"Abstract", "Smallest"},
                                                        {"Abstract", "Largest"},
                                                        {"figure 27", "Start of the second window"},
                                                        {"Section 4.3.2", "Mean offset of the launch"}}) {
    const Claim claim = row(place, what);
    EXPECT_EQ(claim.finding, Finding::reproduced) << what;
    EXPECT_EQ(claim.basis, Basis::derived) << what;
  }
}

TEST(Print, TheSwirlIsHalfAsFarOutAsTheFinsAreWide) {
  EXPECT_EQ(row("Section 4.1.2", "Where the swirl is").ours, "50 to 150 mm");
}

TEST(Print, AChangeSmallerThanTheGridsStepIsASlip) {
  EXPECT_EQ(row("Section 4.2", "Largest change of the torque").finding, Finding::error_in_print);
}

}  // namespace
}  // namespace fantail::paper
