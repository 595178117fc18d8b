// SPDX-License-Identifier: MIT
// The publication repeated as a whole.
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "system/refusal.hpp"

namespace fantail::test {
namespace {

class Paper : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    const Outcome outcome = fantail({"paper", "--json", "--out", *folder_ / "paper"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    ASSERT_EQ(outcome.err, "");
    result_ = new json::Value(json::parse(outcome.out));
  }
  static void TearDownTestSuite() {
    delete result_;
    delete folder_;
  }

  // The claims whose place and text hold these words.
  static std::vector<json::Value> claims(const std::string& place, const std::string& what) {
    std::vector<json::Value> found;
    for (const json::Value& claim : (*result_)["claims"]) {
      if (claim["place"].text().find(place) != std::string::npos &&
          claim["what"].text().find(what) != std::string::npos) {
        found.push_back(claim);
      }
    }
    return found;
  }
  static std::string finding(const std::string& place, const std::string& what) {
    const auto found = claims(place, what);
    return found.size() == 1 ? found[0]["finding"].text() : std::to_string(found.size()) + " claims";
  }

  static inline Folder* folder_ = nullptr;
  static inline json::Value* result_ = nullptr;
};

TEST_F(Paper, EveryStepOfTable2IsFoundAgain) {
  const auto rows = claims("Table 2, step", "Damping");
  EXPECT_EQ(rows.size(), 8U);
  for (const json::Value& row : rows) {
    EXPECT_EQ(row["finding"], "reproduced") << row;
  }
}

TEST_F(Paper, HeightSpeedAndControlStartOfBothLaunchesAreReproduced) {
  EXPECT_EQ(finding("Section 4.2", "Apogee"), "reproduced");
  EXPECT_EQ(finding("Section 4.2", "Highest speed"), "reproduced");
  EXPECT_EQ(finding("Section 4.2", "Control starts"), "reproduced");
  EXPECT_EQ(finding("Section 4.3.2", "Apogee"), "reproduced");
  EXPECT_EQ(finding("Section 4.3.2", "Highest speed"), "reproduced");
  EXPECT_EQ(finding("Figure 19", "limit of 6 degrees"), "reproduced");
  EXPECT_EQ(finding("Figure 21a", "modelled"), "reproduced");
}

TEST_F(Paper, TheSlipsOfThePrintAreNamed) {
  EXPECT_EQ(finding("Table 2, mean", "offset at the begin"), "error_in_print");
  EXPECT_EQ(finding("Table 2", "Heading of the error columns"), "error_in_print");
  EXPECT_EQ(finding("Section 4.3.2", "Launch 2's torque constant"), "error_in_print");
  EXPECT_EQ(finding("Section 4.1.2", "Reduction"), "error_in_print");
  EXPECT_EQ(finding("Section 4.3.2", "Second window's damping and torque constant"), "error_in_print");
  EXPECT_EQ(finding("Section 4.1", "wall"), "error_in_print");
  EXPECT_EQ(finding("Eq 34", "Grid of torque constants"), "error_in_print");
  EXPECT_EQ(finding("Section 4.2", "Unit of the mean angle error"), "error_in_print");
}

TEST_F(Paper, ATimeThatAnotherMotorCouldMeetIsADifferenceAndTheBoundIsSaid) {
  const auto rows = claims("Section 4.2", "Time to apogee");
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["finding"], "differs");
  EXPECT_NE(rows[0]["why"].text().find("boost and sustain"), std::string::npos) << rows[0];
}

TEST_F(Paper, TheSecondControlStartIsHeldAgainstFigure27) {
  const auto rows = claims("figure 27", "Control starts");
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["finding"], "differs");
  EXPECT_EQ(rows[0]["theirs"], "0.50 s");
}

TEST_F(Paper, WhatLostItsMinusIsShownAsItWasPrinted) {
  const auto step = claims("Table 2, step 7", "Damping");
  ASSERT_EQ(step.size(), 1U);
  EXPECT_NE(step[0]["theirs"].text().find(" to 7.41 deg"), std::string::npos) << step[0];
  const auto mean = claims("Table 2, mean", "Mean offset at the end");
  ASSERT_EQ(mean.size(), 1U);
  EXPECT_EQ(mean[0]["why"], "Printed without its minus sign.");
}

TEST_F(Paper, AnAgreementSaysWhatItRestsOn) {
  const auto basis = [](const std::string& place, const std::string& what) {
    const auto found = claims(place, what);
    return found.size() == 1 ? found[0]["basis"].text() : std::to_string(found.size()) + " claims";
  };
  EXPECT_EQ(basis("Section 4.2", "Apogee"), "fitted");
  EXPECT_EQ(basis("Section 4.3.2", "Highest speed"), "fitted");
  EXPECT_EQ(basis("Figure 21a", "modelled"), "fitted");
  EXPECT_EQ(basis("Table 2, step 3", "Damping"), "round_trip");
  EXPECT_EQ(basis("Table 2, mean", "Mean damping"), "derived");
  EXPECT_EQ((*result_)["reproduced"].number(), (*result_)["reproduced_derived"].number() +
                                                   (*result_)["reproduced_fitted"].number() +
                                                   (*result_)["reproduced_round_trip"].number());
}

TEST_F(Paper, WhateverCameOutDifferentlyHasAReason) {
  std::set<std::string> findings;
  for (const json::Value& claim : (*result_)["claims"]) {
    findings.insert(claim["finding"].text());
    if (claim["finding"] != "reproduced") {
      EXPECT_FALSE(claim["why"].text().empty()) << claim;
    }
    EXPECT_NE(claim["why"], "The reason is not known.") << claim;
    EXPECT_EQ(claim["ours"].text().find("nan"), std::string::npos) << claim;
  }
  EXPECT_EQ(findings.size(), 4U);
}

TEST_F(Paper, ThePageIsCompleteAndLoadsNothing) {
  EXPECT_EQ(folder_->listing(), (Words{"paper", "paper/paper.html", "paper/paper.json"}));
  const std::string page = content(folder_->path() / "paper/paper.html");
  for (const char* chapter : {"The air of the tunnel", "Swirl", "Launch 1", "Steps in the wind tunnel", "Launch 2",
                              "The print, held against itself", "The printed figures and tables"}) {
    EXPECT_NE(page.find(chapter), std::string::npos) << chapter;
  }
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("href=\"http"), std::string::npos);
  std::size_t drawn = 0;
  for (std::size_t at = page.find("<svg"); at != std::string::npos; at = page.find("<svg", at + 1)) {
    ++drawn;
  }
  EXPECT_GE(drawn, 15U);
}

TEST_F(Paper, GivesTheSameBytesTwice) {
  const Outcome again = fantail({"paper", "--json", "--out", *folder_ / "again"});
  EXPECT_EQ(json::parse(again.out), *result_);
  EXPECT_EQ(content(folder_->path() / "again/paper.html"), content(folder_->path() / "paper/paper.html"));
  std::filesystem::remove_all(folder_->path() / "again");
}

TEST(PaperTrouble, AFolderThatCannotBeMadeIsNamed) {
  const Folder folder;
  (void)folder.write("taken", "a file");
  const Outcome outcome = fantail({"paper", "--out", folder / "taken/paper"});
  EXPECT_EQ(outcome.exit_code, 74);
  EXPECT_NE(outcome.err.find("taken"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace fantail::test
