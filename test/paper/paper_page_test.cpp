// SPDX-License-Identifier: MIT
#include "paper/paper_page.hpp"

#include <array>

#include <gtest/gtest.h>

#include "paper/printed_sentences.hpp"

namespace fantail::paper {
namespace {

Claim agreeing(Basis basis) { return {.what = "a number", .finding = Finding::reproduced, .basis = basis}; }

TEST(PaperPage, TheSummaryCountsAgreementsByWhatTheyRestOn) {
  const std::array chapters{Chapter{.title = "one",
                                    .claims = {agreeing(Basis::derived), agreeing(Basis::derived),
                                               agreeing(Basis::fitted), agreeing(Basis::round_trip)}}};
  const std::string said = summary(tally(chapters));
  EXPECT_NE(said.find("4 statements are reproduced: 2 are derived from other printed numbers, 1 are met by"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("and 1 are round trips through our own simulator"), std::string::npos) << said;
}

TEST(PaperPage, EachRowSaysItsBasis) {
  const std::array chapters{Chapter{.title = "one", .claims = {agreeing(Basis::round_trip)}}};
  EXPECT_NE(paper_html(chapters, "1").find("<td>round trip</td>"), std::string::npos);
  EXPECT_NE(paper_json(chapters, "1").find("\"basis\": \"round_trip\""), std::string::npos);
}

TEST(PaperPage, NumbersThatNoRowComparesAreListedWithTheReason) {
  const std::string page = paper_html({}, "1");
  for (const PrintedSentence& sentence : printed_sentences) {
    EXPECT_FALSE(sentence.here.empty()) << sentence.numbers;
    EXPECT_NE(page.find(sentence.place), std::string::npos) << sentence.place;
  }
}

TEST(PaperPage, AStatementWithoutAnythingOfOursIsNotCalledARoundTrip) {
  EXPECT_EQ(unpublished("a", "b", "c", "d").basis, Basis::none);
  EXPECT_EQ(unpublished("a", "b", "c", "d", "ours").basis, Basis::round_trip);
}

}  // namespace
}  // namespace fantail::paper
