// SPDX-License-Identifier: MIT
#include "paper/paper_page.hpp"

#include <array>
#include <numeric>

#include <gtest/gtest.h>

namespace fantail::paper {
namespace {

Claim agreeing(Kind kind) { return {.what = "a number", .kind = kind}; }

TEST(PaperPage, TheSummaryCountsEachKindApart) {
  const std::array chapters{
      Chapter{.title = "one",
              .claims = {agreeing(Kind::computed), agreeing(Kind::computed), agreeing(Kind::simulated),
                         agreeing(Kind::fitted), agreeing(Kind::read_back), agreeing(Kind::read_back)}}};
  const std::string said = summary(tally(chapters));
  EXPECT_NE(said.find("3 statements are reproduced: 2 computed from other printed numbers, 1 simulated, 0 described"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("Not counted among them: 1 that our inputs were fitted to, 2 read back"), std::string::npos)
      << said;
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
