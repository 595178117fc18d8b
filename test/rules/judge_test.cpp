// SPDX-License-Identifier: MIT
#include "rules/judge.hpp"

#include "input/scratch_file.hpp"
#include "test.hpp"

namespace fantail::rules {
namespace {

using Words = std::vector<std::string>;

/// A pack with a clause for each of these: kind and what belongs to it.
Pack pack_of(const std::vector<std::string>& clauses) {
  std::string text =
      "title = \"Our range\"\ndate = \"2026-01-31\"\ndocument = \"its rules\"\ndocument_sha256 = \"\"\n"
      "[team]\nnew_system = true\n";
  for (std::size_t i = 0; i < clauses.size(); ++i) {
    text += "[[clauses]]\nid = \"" + std::to_string(i + 1) +
            "\"\ntitle = \"t\"\nwords = \"w\"\nsource = \"s\"\ndate = \"d\"\n" + clauses[i] + "\n";
  }
  const input::ScratchFile file{text};
  return read_pack(input::Document::load(file.path()));
}

const std::string passes = "kind = \"log\"\npasses_if = \"flight.burnout_s < 4\"";
const std::string fails = "kind = \"log\"\npasses_if = \"flight.burnout_s > 4\"";
const std::string unknown = "kind = \"computed\"\npasses_if = \"rocket.margin_calibres > 1\"";
const std::string blank = "kind = \"blank\"\nteam_shows = \"the lock\"\nevidence = [\"flight.burnout_s\"]";
const std::string not_for_us = "kind = \"log\"\napplies_if = \"not team.new_system\"\npasses_if = \"false\"";

const Subject subject{.what = "a flight",
                      .found = {{"flight.burnout_s", {exactly(3.19), "seen"}}},
                      .why_missing = "a log does not tell it"};

std::vector<Outcome> outcomes(const std::vector<Judged>& judged) {
  std::vector<Outcome> all;
  std::ranges::transform(judged, std::back_inserter(all), &Judged::outcome);
  return all;
}

TEST(Judge, GivesEachClauseItsOutcomeWithEvidence) {
  const std::vector<Judged> judged = judge(pack_of({passes, fails, unknown, blank, not_for_us}), subject);
  using enum Outcome;
  EXPECT_EQ(outcomes(judged), (std::vector{pass, fail, not_known, blank, not_applicable}));
  EXPECT_EQ(judged[0].evidence, (std::vector<std::string>{"flight.burnout_s = 3.19 s (seen)"}));
  EXPECT_EQ(judged[2].evidence,
            (std::vector<std::string>{"rocket.margin_calibres = not known (a log does not tell it)"}));
  EXPECT_EQ(judged[3].evidence, (std::vector<std::string>{"flight.burnout_s = 3.19 s (seen)"}));
  EXPECT_EQ(judged[4].evidence, (std::vector<std::string>{"team.new_system = yes (stated in the pack)"}));
}

TEST(Judge, OfAPlanAloneJudgesNoClauseThatNeedsAFlight) {
  Subject alone = subject;
  alone.plan_alone = true;
  const std::string of_plan = "kind = \"plan\"\npasses_if = \"team.new_system\"";
  const std::vector<Judged> judged = judge(pack_of({passes, unknown, blank, of_plan}), alone);
  using enum Outcome;
  EXPECT_EQ(outcomes(judged), (std::vector{not_judged, not_judged, Outcome::blank, pass}));
  EXPECT_EQ(verdict(judged).sentence,
            "1 of 4 clauses passes. Not judged: 1 for the team to show (3), 2 that need a flight (1; 2).");
}

// The canards' law is the same whatever the plan.
TEST(Judge, OfAPlanAloneJudgesAComputedClauseThatNeedsNoFlight) {
  Subject alone{.what = "a plan", .found = of_law(), .why_missing = "a plan does not tell it", .plan_alone = true};
  const std::string of_the_law = "kind = \"computed\"\npasses_if = \"not law.steers_to_place\"";
  EXPECT_EQ(outcomes(judge(pack_of({of_the_law, unknown}), alone)), (std::vector{Outcome::pass, Outcome::not_judged}));
}

TEST(Judge, FailsABlankClauseWhereThereIsNothingToShow) {
  const std::string abort =
      "kind = \"blank\"\nteam_shows = \"the signal\"\nfails_if = 'plan.run.abort_input == \"none\"'";
  const auto of = [&](const Findings& found) {
    return judge(pack_of({abort}), {.what = "a plan", .found = found, .why_missing = "not there"}).front();
  };
  EXPECT_EQ(of({{"plan.run.abort_input", {"none", ""}}}).outcome, Outcome::fail);
  EXPECT_EQ(of({{"plan.run.abort_input", {"none", ""}}}).evidence, (Words{"plan.run.abort_input = \"none\""}));
  EXPECT_EQ(of({{"plan.run.abort_input", {"open_aborts", ""}}}).outcome, Outcome::blank);
  EXPECT_EQ(of({}).outcome, Outcome::not_known);
}

TEST(Judge, ShowsOnlyTheEvidenceThatDecides) {
  const std::string gate =
      "kind = \"plan\"\npasses_if = 'plan.dormancy.until != \"height\" or plan.dormancy.height_m >= 2000'";
  const std::vector<Judged> judged =
      judge(pack_of({gate}),
            {.what = "a plan",
             .found = {{"plan.dormancy.until", {"burn_out", ""}}, {"plan.dormancy.height_m", {exactly(0), ""}}},
             .why_missing = ""});
  EXPECT_EQ(judged[0].evidence, (Words{"plan.dormancy.until = \"burn_out\""}));
}

TEST(RulesVerdict, SaysHowToNameTheRocketWhereAClauseNeedsIt) {
  Subject log = subject;
  log.no_rocket = "use --vehicle";
  const auto said = [&](const std::vector<std::string>& clauses) {
    return verdict(judge(pack_of(clauses), log), log).sentence;
  };
  EXPECT_NE(said({passes, unknown}).find(" The rocket is not known: use --vehicle."), std::string::npos);
  EXPECT_EQ(said({passes}).find("rocket"), std::string::npos);
}

TEST(RulesVerdict, NamesWhatFailsAndWhatWasNotJudged) {
  const result::Verdict no = verdict(judge(pack_of({passes, fails, unknown, blank, not_for_us}), subject));
  EXPECT_EQ(no.answer, result::Answer::no);
  EXPECT_EQ(no.sentence,
            "1 of 5 clauses fails: 2; 1 passes. Not judged: 1 for the team to show (4), 1 not known (3), 1 not "
            "applicable (5).");
}

TEST(RulesVerdict, IsNoYesWhereAFigureIsUnknownOrNothingWasJudged) {
  EXPECT_EQ(verdict(judge(pack_of({passes, unknown}), subject)).answer, result::Answer::undecided);
  EXPECT_EQ(verdict(judge(pack_of({blank}), subject)).answer, result::Answer::undecided);
  EXPECT_EQ(verdict(judge(pack_of({not_for_us}), subject)).answer, result::Answer::undecided);
  const result::Verdict yes = verdict(judge(pack_of({passes, passes}), subject));
  EXPECT_EQ(yes.answer, result::Answer::yes);
  EXPECT_EQ(yes.sentence, "2 of 2 clauses pass. Every clause was judged.");
  EXPECT_FALSE(yes.with_caution);
  EXPECT_TRUE(verdict(judge(pack_of({passes, blank}), subject)).with_caution);
}

TEST(RulesPage, BearsTheWordsAndWhatWasCompared) {
  Pack pack = pack_of({passes});
  const auto page = [&] { return result::html(answer(pack, subject, judge(pack, subject), {})); };
  for (const char* said : {"Check against the current document (its rules).", "no legal advice",
                           "Nobody has compared them with that document.", "Compared: a flight, with the pack plan."}) {
    EXPECT_NE(page().find(said), std::string::npos) << said;
  }
  pack.document_sha256 = std::string(64, 'a');
  EXPECT_NE(page().find("compared them with the document of SHA-256 aaaa"), std::string::npos);
  EXPECT_EQ(page().find("Nobody has compared"), std::string::npos);
}

}  // namespace
}  // namespace fantail::rules
