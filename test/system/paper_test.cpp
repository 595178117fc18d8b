// SPDX-License-Identifier: MIT
// The publication repeated as a whole.
#include <regex>

#include "system/refusal.hpp"

namespace fantail::test {
namespace {

class Paper : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    const Outcome outcome = fantail({"paper", "--json", "--out", *folder_ / "paper"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    // On a busy PC it says how far it is.
    ASSERT_TRUE(std::regex_match(outcome.err, std::regex{"(paper: .+ \\(part [1-7] of 7\\), [0-9]+ s\\n)*"}))
        << outcome.err;
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

TEST_F(Paper, EveryStepOfTable2IsFoundAgainAndNoneIsCalledReproduced) {
  const auto rows = claims("Table 2, step", "Damping");
  EXPECT_EQ(rows.size(), 8U);
  for (const json::Value& row : rows) {
    EXPECT_EQ(row["finding"], "read_back") << row;
  }
  for (const json::Value& claim : (*result_)["claims"]) {
    if (claim["kind"] == "read_back" || claim["kind"] == "fitted") {
      EXPECT_NE(claim["finding"], "reproduced") << claim;
    }
  }
}

TEST_F(Paper, HeightSpeedAndControlStartOfBothLaunchesAreMetByAFit) {
  EXPECT_EQ(finding("Section 4.2", "Apogee"), "fitted");
  EXPECT_EQ(finding("Section 4.2", "Highest speed"), "fitted");
  EXPECT_EQ(finding("Section 4.2", "Control starts"), "fitted");
  EXPECT_EQ(finding("Section 4.3.2", "Apogee"), "fitted");
  EXPECT_EQ(finding("Section 4.3.2", "Highest speed"), "fitted");
  EXPECT_EQ(finding("Figure 19", "limit of 6 degrees"), "reproduced");
  EXPECT_EQ(finding("Figure 21a", "modelled"), "fitted");
}

TEST_F(Paper, TheCountsOfTheKindsAddUpToAllRows) {
  std::map<std::string, double> counted;
  double all = 0.0;
  for (const json::Value& claim : (*result_)["claims"]) {
    if (claim["finding"] != "differs") {
      counted[claim["kind"].text()] += 1.0;
    }
    all += 1.0;
  }
  double sum = (*result_)["differs"].number();
  for (const json::Member& kind : (*result_)["kinds"].members()) {
    EXPECT_EQ(kind.value.number(), counted[kind.key]) << kind.key;
    sum += kind.value.number();
  }
  EXPECT_EQ(sum, all);
  EXPECT_EQ((*result_)["reproduced"].number(), counted["computed"] + counted["simulated"] + counted["described"]);
}

// Those with data in them; the others are photographs.
TEST_F(Paper, EveryEquationAndEveryFigureWithDataHasARow) {
  std::set<int> equations;
  std::set<int> figures;
  const std::regex group{"(eq|figure)s? ((?:[0-9]+[ab]?(?:, | and | to )?)+)", std::regex::icase};
  const std::regex number{"([0-9]+)[ab]?( to )?"};
  for (const json::Value& claim : (*result_)["claims"]) {
    const std::string place = claim["place"].text();
    for (std::sregex_iterator found{place.begin(), place.end(), group}; found != std::sregex_iterator{}; ++found) {
      const std::string list = (*found)[2];
      std::set<int>& named = (*found)[1].str().front() == 'e' || (*found)[1].str().front() == 'E' ? equations : figures;
      int from = 0;
      for (std::sregex_iterator one{list.begin(), list.end(), number}; one != std::sregex_iterator{}; ++one) {
        const int value = std::stoi((*one)[1]);
        for (int i = from > 0 ? from : value; i <= value; ++i) {
          named.insert(i);
        }
        from = (*one)[2].matched ? value : 0;
      }
    }
  }
  for (int equation = 1; equation <= 52; ++equation) {
    EXPECT_TRUE(equations.contains(equation)) << "Eq " << equation;
  }
  for (const int figure : {10, 11, 14, 15, 16, 18, 19, 20, 21, 22, 23, 24, 26, 27, 28, 29, 30, 31}) {
    EXPECT_TRUE(figures.contains(figure)) << "figure " << figure;
  }
}

TEST_F(Paper, EachRowCitesItsPlace) {
  const std::regex place{"Abstract|Notation|(Section [0-9]|Eq [0-9]|Figure [0-9]|Table [12]).*"};
  for (const json::Value& claim : (*result_)["claims"]) {
    EXPECT_TRUE(std::regex_match(claim["place"].text(), place)) << claim["place"];
  }
}

TEST_F(Paper, TheSlipsOfThePrintAreNamed) {
  EXPECT_EQ(finding("Table 2, mean", "offset at the begin"), "error_in_print");
  EXPECT_EQ(finding("Table 2", "Heading of the error columns"), "error_in_print");
  EXPECT_EQ(finding("Section 4.3.2", "Launch 2's torque constant"), "error_in_print");
  EXPECT_EQ(finding("Section 4.1.2", "Reduction"), "error_in_print");
  EXPECT_EQ(finding("Section 4.3.2", "Second window's damping and torque constant"), "error_in_print");
  EXPECT_EQ(finding("Section 4.1", "outermost point"), "error_in_print");
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
  const auto kind = [](const std::string& place, const std::string& what) {
    const auto found = claims(place, what);
    return found.size() == 1 ? found[0]["kind"].text() + ", " + found[0]["basis"].text()
                             : std::to_string(found.size()) + " claims";
  };
  EXPECT_EQ(kind("Section 4.2", "Apogee"), "fitted, fitted");
  EXPECT_EQ(kind("Section 4.3.2", "Highest speed"), "fitted, fitted");
  EXPECT_EQ(kind("Figure 21a", "modelled"), "fitted, fitted");
  EXPECT_EQ(kind("Section 4.2", "Oscillation"), "fitted, fitted");
  EXPECT_EQ(kind("Section 4.2", "Time to apogee"), "fitted, fitted");
  EXPECT_EQ(kind("Table 2, step 3", "Damping"), "read_back, round_trip");
  EXPECT_EQ(kind("Table 2, mean", "Mean damping"), "computed, derived");
  EXPECT_EQ(kind("Eq 47", "first window"), "read_back, round_trip");
  EXPECT_EQ(kind("figure 23", "direction"), "described, simulated");
  EXPECT_EQ(kind("Section 4.3.1", "Canard-fin interaction"), "described, simulated");
  EXPECT_EQ(kind("Eq 45 and 46", "Form"), "definition, none");
  EXPECT_EQ(kind("Section 4.1", "100 mm from the wall"), "not_reproducible, none");
  EXPECT_EQ((*result_)["reproduced"].number(),
            (*result_)["reproduced_derived"].number() + (*result_)["reproduced_simulated"].number() +
                (*result_)["reproduced_described"].number() + (*result_)["reproduced_fitted"].number() +
                (*result_)["reproduced_round_trip"].number());
}

TEST_F(Paper, WhateverCameOutDifferentlyHasAReason) {
  std::set<std::string> findings;
  for (const json::Value& claim : (*result_)["claims"]) {
    findings.insert(claim["finding"].text());
    if (claim["finding"] == "differs" || claim["finding"] == "error_in_print" ||
        claim["finding"] == "not_reproducible" || claim["finding"] == "outside") {
      EXPECT_FALSE(claim["why"].text().empty()) << claim;
    }
    EXPECT_NE(claim["why"], "The reason is not known.") << claim;
    EXPECT_EQ(claim["ours"].text().find("nan"), std::string::npos) << claim;
  }
  EXPECT_EQ(findings.size(), 8U);
}

TEST_F(Paper, ThePageIsCompleteAndLoadsNothing) {
  EXPECT_EQ(folder_->listing(), (Words{"paper", "paper/paper.html", "paper/paper.json"}));
  const std::string page = content(folder_->path() / "paper/paper.html");
  expect_said(page, {"The air of the tunnel", "Swirl", "Launch 1", "Steps in the wind tunnel", "Launch 2",
                     "The publication, checked against itself", "The printed figures and tables"});
  EXPECT_EQ(page.find("src="), std::string::npos);
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
  expect_said(outcome.err, {"taken"});
}

}  // namespace
}  // namespace fantail::test
