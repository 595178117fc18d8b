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
  EXPECT_EQ(finding(claim), "reproduced");
  EXPECT_EQ(claim.theirs, "2.00 m");
  EXPECT_EQ(claim.ours, "2.10 m");
  EXPECT_EQ(claim.difference, "0.10 m");
  EXPECT_EQ(claim.why, "all is well");
}

TEST(Claim, BeyondItItDiffersWithTheReason) {
  const Claim claim = compare(numbers(2.0, 2.11, 0.1));
  EXPECT_EQ(finding(claim), "differs");
  EXPECT_EQ(kind_words(claim), "simulated, differs");
  EXPECT_EQ(claim.why, "because");
}

TEST(Claim, ADifferenceWithoutAReasonSaysSo) {
  Numbers without = numbers(2.0, 3.0, 0.1);
  without.why_otherwise.clear();
  EXPECT_EQ(compare(without).why, "The reason is not known.");
}

TEST(Claim, NotANumberIsNoAgreement) {
  EXPECT_EQ(finding(compare(numbers(2.0, std::numeric_limits<double>::quiet_NaN(), 0.1))), "differs");
}

TEST(Claim, ARoundTripAndAFitAreNeverReproducedHoweverWellTheyAgree) {
  for (const auto& [kind, found] : {std::pair{Kind::read_back, "read_back"}, std::pair{Kind::fitted, "fitted"}}) {
    Numbers same = numbers(2.0, 2.0, 0.1);
    same.kind = kind;
    EXPECT_EQ(finding(compare(same)), found);
    EXPECT_FALSE(counts_as_reproduced(kind));
  }
}

TEST(Claim, OnlyWhatWasMadeWithoutThePrintedValueCanBeReproduced) {
  std::size_t can = 0;
  for (const Kind kind : kinds) {
    can += counts_as_reproduced(kind) ? 1 : 0;
    EXPECT_EQ(finding({.kind = kind}), counts_as_reproduced(kind) ? "reproduced" : name(kind));
  }
  EXPECT_EQ(can, 3U);
}

TEST(Claim, EachKindHasANameAndWords) {
  EXPECT_EQ(name(Kind::error_in_print), "error_in_print");
  EXPECT_EQ(words(Kind::read_back), "read back");
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    EXPECT_EQ(place_of(kinds[i]), i);
    EXPECT_FALSE(name(kinds[i]).empty());
  }
}

TEST(Claim, ReadersOfTheOldKeyStillGetABasis) {
  EXPECT_EQ(basis({.kind = Kind::computed}), "derived");
  EXPECT_EQ(basis({.kind = Kind::read_back}), "round_trip");
  EXPECT_EQ(basis({.kind = Kind::fitted}), "fitted");
  EXPECT_EQ(basis({.kind = Kind::not_reproducible}), "none");
}

}  // namespace
}  // namespace fantail::paper
