// SPDX-License-Identifier: MIT
#include "paper/claim.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace fantail::paper {
namespace {

Numbers numbers(double theirs, double ours, double tolerance) {
  return {.place = "Eq 1",
          .what = "a number",
          .theirs = theirs,
          .ours = ours,
          .unit = "m",
          .decimals = 2,
          .tolerance = tolerance,
          .why_otherwise = "because",
          .remark = "all is well"};
}

TEST(Claim, WithinTheToleranceItIsReproduced) {
  const Claim claim = compare(numbers(2.0, 2.1, 0.1));
  EXPECT_EQ(claim.finding, Finding::reproduced);
  EXPECT_EQ(claim.theirs, "2.00 m");
  EXPECT_EQ(claim.ours, "2.10 m");
  EXPECT_EQ(claim.difference, "0.10 m");
  EXPECT_EQ(claim.why, "all is well");
}

TEST(Claim, BeyondItItDiffersWithTheReason) {
  const Claim claim = compare(numbers(2.0, 2.11, 0.1));
  EXPECT_EQ(claim.finding, Finding::differs);
  EXPECT_EQ(claim.why, "because");
}

TEST(Claim, ADifferenceWithoutAReasonSaysSo) {
  Numbers without = numbers(2.0, 3.0, 0.1);
  without.why_otherwise.clear();
  EXPECT_EQ(compare(without).why, "The reason is not known.");
}

TEST(Claim, NotANumberIsNoAgreement) {
  EXPECT_EQ(compare(numbers(2.0, std::numeric_limits<double>::quiet_NaN(), 0.1)).finding, Finding::differs);
}

TEST(Claim, EachFindingHasANameAndWords) {
  EXPECT_EQ(name(Finding::error_in_print), "error_in_print");
  EXPECT_EQ(words(Finding::not_reproducible), "not reproducible without the data");
}

}  // namespace
}  // namespace fantail::paper
