// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

#include "rules/judge.hpp"

namespace fantail::rules {
namespace {

using result::Cell;
namespace u = result::units;

result::Answer answer_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::pass: return result::Answer::yes;
    case Outcome::fail: return result::Answer::no;
    case Outcome::not_known: return result::Answer::undecided;
    case Outcome::blank:
    case Outcome::not_applicable:
    case Outcome::not_judged: break;
  }
  return result::Answer::none;
}

std::string lines(const Judged& judged) {
  std::string all = judged.clause.team_shows.empty() ? "" : "The team must show: " + judged.clause.team_shows;
  for (const std::string& one : judged.evidence) {
    all += (all.empty() ? "" : "; ") + one;
  }
  return all;
}

using J = Judged;
constexpr auto clause_fields = result::fields<J>({
    {"id", "clause", u::none, 0, [](const J& j) { return Cell{j.clause.id}; }, "its name in the pack"},
    {"title", "about", u::none, 0, [](const J& j) { return Cell{j.clause.title}; }, "what it is about"},
    {"outcome", "result", u::none, 0,
     [](const J& j) { return Cell{result::Judged{answer_of(j.outcome), std::string{name(j.outcome)}}}; },
     "PASS, FAIL, BLANK (the team must show it), NOT_APPLICABLE, NOT_KNOWN or NOT_JUDGED"},
    {"words", "in our words", u::none, 0, [](const J& j) { return Cell{j.clause.words}; }, "what it asks for"},
    {"evidence", "evidence", u::none, 0, [](const J& j) { return Cell{lines(j)}; },
     "each figure and field that it names, with its value; what the team must show"},
    {"kind", "judged from", u::none, 0, [](const J& j) { return Cell{std::string{name(j.clause.kind)}}; },
     "computed, plan, log or blank"},
    {"source", "source", u::none, 0, [](const J& j) { return Cell{j.clause.source}; }, "the document that it is from"},
    {"date", "date", u::none, 0, [](const J& j) { return Cell{j.clause.date}; }, "of that document, as far as known"},
});

struct Group {
  Outcome outcome;
  std::string_view heading;
};
constexpr std::array groups{Group{Outcome::fail, "Fail"},
                            Group{Outcome::not_known, "Not known"},
                            Group{Outcome::blank, "For the team to show"},
                            Group{Outcome::pass, "Pass"},
                            Group{Outcome::not_applicable, "Not applicable"},
                            Group{Outcome::not_judged, "Not judged"}};

/// For people: the clauses of each outcome below each other.
std::vector<result::Section> sections(const std::vector<Judged>& judged) {
  std::vector<result::Section> all;
  for (const Group& group : groups) {
    std::vector<Judged> of_it;
    std::ranges::copy_if(judged, std::back_inserter(of_it),
                         [&](const Judged& one) { return one.outcome == group.outcome; });
    result::Table table = result::only(result::table({}, of_it, clause_fields), {"id", "outcome", "words", "evidence"});
    all.push_back({.heading = std::string{group.heading}, .blocks = {std::move(table)}});
  }
  return all;
}

}  // namespace

std::vector<result::Listed> listed_fields() { return {result::listed("clauses[]", clause_fields)}; }

result::Document answer(const Pack& pack, const Subject& subject, const std::vector<Judged>& judged,
                        const result::Made& made) {
  using enum result::Readers;
  const result::Table table = result::table("clauses", judged, clause_fields);
  result::Table sources = result::only(table, {"id", "title", "kind", "source", "date"});
  sources.key.reset();
  std::vector<std::string> notes = pack.notes;
  for (const auto& [name, stated] : pack.team) {
    notes.push_back(fmt::format("Stated in the pack: {} = {}. Change it there if it is not so.", name,
                                value_text(name, stated.known)));
  }
  result::Verdict headline = verdict(judged, subject);
  headline.beside = {caution(pack), fmt::format("Compared: {}, with the pack {}.", subject.what, pack.name)};
  std::vector<result::Section> shown = sections(judged);
  shown.insert(shown.end(), {{"Sources", {std::move(sources)}, files},
                             {"For programs", {table}, programs},
                             {"About this pack", {result::Sentences{"notes", std::move(notes)}}}});
  return {.kind = "rules check",
          .title = pack.title,
          .subtitle = subject.what,
          .verdict = std::move(headline),
          .facts = {{"pack", "", pack.name},
                    {"pack_date", "", pack.date},
                    {"document", "", pack.document},
                    {"document_sha256", "", pack.document_sha256},
                    {"compared", "", subject.what},
                    {"caution", "", caution(pack)}},
          .sections = std::move(shown),
          .made = made,
          .footer = caution(pack)};
}

}  // namespace fantail::rules
