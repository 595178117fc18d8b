// SPDX-License-Identifier: MIT
#include "rules/pack.hpp"

#include "input/scratch_file.hpp"
#include "input/shipped.hpp"
#include "test.hpp"

namespace fantail::rules {
namespace {

constexpr const char* head =
    "title = \"Our range\"\ndate = \"2026-01-31\"\ndocument = \"its rules\"\ndocument_sha256 = \"\"\n"
    "[team]\nheight_m = 900\n";
constexpr const char* clause_begin =
    "[[clauses]]\nid = \"3.1\"\ntitle = \"t\"\nwords = \"w\"\nsource = \"rules 3.1\"\ndate = \"2026\"\n";

std::string clause(const std::string& rest) { return std::string{clause_begin} + rest; }
const std::string good = clause("kind = \"plan\"\npasses_if = \"plan.dormancy.height_m >= team.height_m\"\n");

Pack read(const std::string& text) {
  const input::ScratchFile file{text};
  return read_pack(input::Document::load(file.path()));
}

/// Its message begins with the line of the file.
void expect_refused(const std::string& text, const std::vector<std::string>& said) {
  const input::Complaint found = input::complaint([&] { (void)read(text); });
  EXPECT_EQ(found.fault, text::ErrorKind::bad_configuration);
  EXPECT_TRUE(found.message.starts_with("plan.toml:")) << found.message;
  for (const std::string& part : said) {
    EXPECT_NE(found.message.find(part), std::string::npos) << "not said: " << part << "\n" << found.message;
  }
}

std::string without(std::string text, const std::string& part) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.erase(at, part.size());
}

TEST(Pack, IsReadFromAFile) {
  const Pack pack = read(head + good);
  EXPECT_EQ(pack.title, "Our range");
  EXPECT_EQ(pack.team.at("team.height_m").known, Known{exactly(900.0)});
  ASSERT_EQ(pack.clauses.size(), 1U);
  EXPECT_EQ(pack.clauses[0].id, "3.1");
  EXPECT_EQ(pack.clauses[0].kind, Kind::plan);
  EXPECT_EQ(pack.clauses[0].passes_if->names(), (std::vector<std::string>{"plan.dormancy.height_m", "team.height_m"}));
}

TEST(Pack, WithAnUnknownKeyIsRefused) {
  expect_refused("titel = \"x\"\n" + (head + good), {"plan.toml:1", "unknown key titel", "did you mean title?"});
  expect_refused(head + good + "sorce = \"x\"\n", {"unknown key clauses[\"3.1\"].sorce"});
}

TEST(Pack, OfAClauseWithoutASourceIsRefusedByName) {
  expect_refused(without(head + good, "source = \"rules 3.1\"\n"),
                 {"plan.toml:7", "clauses[\"3.1\"].source is missing"});
  expect_refused(without(head + good, "rules 3.1"), {"plan.toml:11", "clauses[\"3.1\"].source is empty"});
  expect_refused(without(head + good, "date = \"2026\"\n"), {"clauses[\"3.1\"].date is missing"});
}

TEST(Pack, WhoseExpressionNamesNoFigureIsRefusedWithClauseAndPosition) {
  expect_refused(
      head + clause("kind = \"plan\"\npasses_if = \"1 < 2 and plan.run.tilt_limit > 3\"\n"),
      {"plan.toml:14", "clauses[\"3.1\"].passes_if", "position 11",
       "\"plan.run.tilt_limit\" names no figure and no field of a plan; did you mean plan.run.tilt_limit_deg?"});
  expect_refused(head + clause("kind = \"computed\"\npasses_if = \"flight.apogee > 3\"\n"),
                 {"position 1:", "did you mean flight.apogee_m?"});
  expect_refused(head + clause("kind = \"computed\"\npasses_if = \"true\"\nevidence = [\"flight.apogee\"]\n"),
                 {"clauses[\"3.1\"].evidence", "names no figure"});
}

TEST(Pack, WhoseExpressionHasAWrongTypeIsRefusedWithClauseAndPosition) {
  expect_refused(head + clause("kind = \"plan\"\npasses_if = 'plan.run.tilt_from > 30'\n"),
                 {"clauses[\"3.1\"].passes_if", "position 1:", "needs a number here, and this is a text"});
  expect_refused(head + clause("kind = \"plan\"\npasses_if = 'plan.dormancy.until == \"burnout\"'\n"),
                 {"position 24", "is not a value of plan.dormancy.until"});
  expect_refused(head + clause("kind = \"plan\"\npasses_if = 'plan.run.tilt_limit_deg + 1'\n"), {"is not a condition"});
  expect_refused(head + clause("kind = \"plan\"\npasses_if = 3\n"), {"is not a text"});
}

TEST(Pack, WhoseKindsAndKeysDoNotFitIsRefused) {
  expect_refused(head + clause("kind = \"guess\"\n"), {"clauses[\"3.1\"].kind", "allowed: computed, plan, log, blank"});
  expect_refused(head + clause("kind = \"log\"\n"), {"passes_if is missing"});
  expect_refused(head + clause("kind = \"blank\"\n"), {"team_shows is missing"});
  expect_refused(head + clause("kind = \"blank\"\nteam_shows = \"x\"\npasses_if = \"true\"\n"), {"this one is blank"});
  expect_refused(head + clause("kind = \"plan\"\npasses_if = \"true\"\nfails_if = \"true\"\n"),
                 {"fails_if belongs to a clause of kind \"blank\""});
  expect_refused(head + clause("kind = \"plan\"\npasses_if = \"flight.apogee_m > 1\"\n"),
                 {"names flight.apogee_m; a clause of kind \"plan\" may name only plan.* and team.*"});
  expect_refused(head + good + good, {"id = \"3.1\" is the id of an earlier clause, too"});
  expect_refused(head, {"clauses is missing"});
  expect_refused(head + std::string{"[clauses]\nid = 3\n"}, {"clauses is missing; allowed: [[clauses]]"});
}

TEST(Pack, HasTheHashOfADocumentOrNone) {
  const std::string hash(64, 'a');
  std::string text = head + good;
  text.replace(text.find("sha256 = \"\""), 11, "sha256 = \"" + hash + "\"");
  EXPECT_EQ(read(text).document_sha256, hash);
  text.replace(text.find(hash), 64, "abc");
  expect_refused(text, {"plan.toml:4", "document_sha256 = \"abc\"", "64 digits"});
}

class ShippedPack : public testing::TestWithParam<std::string> {};

TEST_P(ShippedPack, IsReadAndNobodyHasComparedItYet) {
  const Pack pack = load_pack(GetParam());
  EXPECT_EQ(pack.name, GetParam());
  EXPECT_EQ(pack.document_sha256, "");
  EXPECT_FALSE(pack.clauses.empty());
}

INSTANTIATE_TEST_SUITE_P(Packs, ShippedPack, testing::ValuesIn(input::shipped_names(input::Shipped::rules)),
                         [](const auto& pack) { return pack.param; });

TEST(ShippedPacks, AreTheFour) {
  EXPECT_EQ(input::shipped_names(input::Shipped::rules),
            (std::vector<std::string>{"euroc", "irec", "launch_canada", "nar_tripoli"}));
}

}  // namespace
}  // namespace fantail::rules
