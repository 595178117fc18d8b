// SPDX-License-Identifier: MIT

#include "paper/claim.hpp"
#include "paper/paper_page.hpp"
#include "paper/print.hpp"
#include "test.hpp"

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

// The rule of the kinds, where a test can look whether a row keeps it: what a number was made from shows when another
// is changed.

Print changed(const Print& print, Number number, double factor) {
  Print other = print;
  other[number] = factor * print[number];
  return other;
}

// A least or a largest of several may take a large change, either way.
bool follows(const Computed& row, const Print& print, Number number) {
  return row.ours(changed(print, number, 10.0)) != row.ours(print) ||
         row.ours(changed(print, number, 0.01)) != row.ours(print);
}

// Whether some other printed number moves ours.
bool follows_another(const Computed& row, const Print& print) {
  const double ours = row.ours(print);
  for (std::size_t i = 0; i < number_count; ++i) {
    const auto number = static_cast<Number>(i);
    if (number != row.theirs && follows(row, print, number)) {
      return true;
    }
  }
  for (const auto member : {&PublishedStep::alpha_m2, &PublishedStep::beta_m, &PublishedStep::disturbance_begin_deg,
                            &PublishedStep::disturbance_end_deg, &PublishedStep::mean_abs_angle_error_deg,
                            &PublishedStep::mean_abs_rate_error_deg_s}) {
    Print other = print;
    for (PublishedStep& step : other.steps) {
      step.*member *= 1.37;
    }
    if (row.ours(other) != ours) {
      return true;
    }
  }
  return false;
}

TEST(Computed, NoRowFollowsItsOwnPrintedNumber) {
  const Print print = Print::as_published();
  for (const Computed& row : computed()) {
    EXPECT_FALSE(follows(row, print, row.theirs)) << row.place << ": " << row.what;
    const Print other = changed(print, row.theirs, 10.0);
    EXPECT_NE(worked_out(row, other).theirs, worked_out(row, print).theirs) << row.place << ": " << row.what;
  }
}

TEST(Computed, EveryRowFollowsSomeOtherPrintedNumber) {
  const Print print = Print::as_published();
  for (const Computed& row : computed()) {
    EXPECT_TRUE(follows_another(row, print)) << row.place << ": " << row.what;
  }
}

TEST(Computed, EveryPrintedNumberOfTheListIsUsed) {
  const Print print = Print::as_published();
  for (std::size_t i = 0; i < number_count; ++i) {
    const auto number = static_cast<Number>(i);
    EXPECT_NE(print[number], 0.0) << i;
    EXPECT_TRUE(std::ranges::any_of(computed(), [&](const Computed& row) {
      return row.theirs == number || follows(row, print, number);
    })) << i;
  }
}

TEST(Computed, ANumberThatTheOthersContradictIsAnErrorInPrint) {
  const Print print = Print::as_published();
  for (const Computed& row : computed()) {
    Print other = print;
    other[row.theirs] = row.ours(print);
    EXPECT_EQ(worked_out(row, other).kind, Kind::computed) << row.what;
    other[row.theirs] += 2.0 * row.tolerance;
    EXPECT_EQ(worked_out(row, other).kind, Kind::error_in_print) << row.what;
  }
}

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
  EXPECT_NE(row->why.find("|4t \u2212 10| Hz. It is 8.4 at 0.4 s, zero at 2.5 s, 18 at 7 s"), std::string::npos)
      << row->why;
}

Claim agreeing(Kind kind) { return {.what = "a number", .kind = kind}; }

TEST(PaperPage, TheSummaryCountsEachKindApart) {
  const std::array chapters{
      Chapter{.title = "one",
              .claims = {agreeing(Kind::computed), agreeing(Kind::computed), agreeing(Kind::simulated),
                         agreeing(Kind::fitted), agreeing(Kind::read_back), agreeing(Kind::read_back)}}};
  const std::string said = summary(tally(chapters));
  EXPECT_NE(
      said.find("3 printed statements are reproduced: 2 computed from other printed numbers, 1 simulated, 0 described"),
      std::string::npos)
      << said;
  EXPECT_NE(said.find("Not counted: 1 that our inputs were fitted to, 2 read back"), std::string::npos) << said;
}

TEST(PaperPage, EveryRowIsCountedOnce) {
  std::array chapters{Chapter{.title = "one"}};
  for (const Kind kind : kinds) {
    chapters[0].claims.push_back(agreeing(kind));
    chapters[0].claims.push_back({.kind = kind, .agrees = false});
  }
  const Tally count = tally(chapters);
  EXPECT_EQ(std::accumulate(count.agreeing.begin(), count.agreeing.end(), count.differs), 2 * kinds.size());
  EXPECT_EQ(count.differs, kinds.size());
  EXPECT_EQ(count.reproduced(), 3U);
}

TEST(PaperPage, EachRowSaysItsKind) {
  const std::array chapters{Chapter{.title = "one", .claims = {agreeing(Kind::read_back)}}};
  EXPECT_NE(paper_html(chapters, "1").find("<td>read back</td>"), std::string::npos);
  const std::string json = paper_json(chapters, "1");
  EXPECT_NE(json.find("\"kind\": \"read_back\""), std::string::npos);
  EXPECT_NE(json.find("\"basis\": \"round_trip\""), std::string::npos);
  EXPECT_NE(json.find("\"reproduced_round_trip\": 0"), std::string::npos);
}

TEST(PaperPage, WhatTeachesNothingOfTheMeasurementIsFoldedUnlessItDiffers) {
  Claim differing = agreeing(Kind::read_back);
  differing.what = "a difference";
  differing.agrees = false;
  const std::array chapters{
      Chapter{.title = "one", .claims = {agreeing(Kind::read_back), differing, agreeing(Kind::definition)}}};
  const std::string page = paper_html(chapters, "1");
  const std::size_t folded = page.find("<details><summary>Rows: 1 read back, 1 definition");
  ASSERT_NE(folded, std::string::npos);
  EXPECT_LT(page.find("<td>a difference</td>"), folded);
  EXPECT_LT(folded, page.find("<td>a number</td>"));
}

}  // namespace

}  // namespace fantail::paper
