// SPDX-License-Identifier: MIT
#include "rules/pack.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <fmt/format.h>

#include "input/messages.hpp"
#include "input/section.hpp"
#include "input/shipped.hpp"

namespace fantail::rules {
namespace {

using input::Section;

constexpr std::array<std::string_view, 4> kind_names{"computed", "plan", "log", "blank"};
constexpr std::size_t most_texts = 100;

std::string text_of(Section& section, std::string_view key) {
  std::string said = section.text(key);
  if (said.empty()) {
    section.refuse(key, "is empty");
  }
  return said;
}

/// Every name with what it stands for.
class Names {
 public:
  explicit Names(const Findings& team) : all_{plan_meanings()} {
    for (const FigureText& figure : figure_texts()) {
      all_[std::string{figure.name}] = {.type = figure.type};
    }
    for (const auto& [name, stated] : team) {
      all_[name] = {.type = static_cast<Type>(stated.known->index())};
    }
  }

  [[nodiscard]] Vocabulary vocabulary() const {
    return {.meaning_of =
                [this](const std::string& name) {
                  const auto found = all_.find(name);
                  return found == all_.end() ? std::nullopt : std::optional{found->second};
                },
            .names =
                [this] {
                  std::vector<std::string> names;
                  for (const auto& [name, meaning] : all_) {
                    names.push_back(name);
                  }
                  return names;
                }};
  }

 private:
  std::map<std::string, Meaning> all_;
};

std::optional<Expression> read_expression(Section& section, std::string_view key, const Names& names) {
  if (!section.has(key)) {
    return std::nullopt;
  }
  const std::string written = section.text(key);
  try {
    Expression read = Expression::parse(written, names.vocabulary());
    if (read.type() != Type::flag) {
      section.refuse(key, "is not a condition; compare it with something");
    }
    return read;
  } catch (const ExpressionError& error) {
    section.refuse(key, fmt::format("= \"{}\", position {}: {}", written, error.position(), error.what()));
  }
}

bool is_of_plan(const std::string& name) { return name.starts_with("plan.") || name.starts_with("team."); }

/// The rules that span several keys of a clause.
void check(Section& section, const Clause& clause) {
  if (clause.kind == Kind::blank) {
    if (clause.passes_if) {
      section.refuse("passes_if", "belongs to a clause that is judged, and this one is blank");
    }
    return;
  }
  if (clause.fails_if) {
    section.refuse("fails_if", "belongs to a clause of kind \"blank\"; this one has passes_if");
  }
  if (!clause.passes_if) {
    section.refuse("passes_if", "is missing; a clause without it is of kind \"blank\"");
  }
  if (clause.kind != Kind::plan) {
    return;
  }
  for (const auto& [key, expression] :
       {std::pair{"passes_if", &clause.passes_if}, {"applies_if", &clause.applies_if}}) {
    const auto names = *expression ? (*expression)->names() : std::vector<std::string>{};
    const auto other = std::ranges::find_if_not(names, is_of_plan);
    if (other != names.end()) {
      section.refuse(key, fmt::format("names {}; a clause of kind \"plan\" may name only plan.* and team.*", *other));
    }
  }
}

Clause read_clause(const input::Document& document, input::TomlNode table, const Names& names) {
  Clause clause;
  clause.id = [&] {
    Section unnamed{document, "clauses", table};
    return text_of(unnamed, "id");
  }();
  Section section{document, fmt::format("clauses[\"{}\"]", clause.id), table};
  (void)section.has("id");
  clause.title = text_of(section, "title");
  clause.words = text_of(section, "words");
  clause.source = text_of(section, "source");
  clause.date = text_of(section, "date");
  clause.kind = static_cast<Kind>(section.choice("kind", kind_names));
  clause.applies_if = read_expression(section, "applies_if", names);
  clause.passes_if = read_expression(section, "passes_if", names);
  clause.fails_if = read_expression(section, "fails_if", names);
  if (clause.kind == Kind::blank) {
    clause.team_shows = text_of(section, "team_shows");
  }
  clause.evidence = section.texts("evidence", most_texts);
  for (const std::string& name : clause.evidence) {
    if (!names.vocabulary().meaning_of(name)) {
      const auto meant = input::suggestion(name, names.vocabulary().names());
      section.refuse("evidence", fmt::format("= \"{}\" names no figure and no field of a plan{}", name,
                                             meant ? "; did you mean " + *meant + "?" : ""));
    }
  }
  section.finish();
  check(section, clause);
  return clause;
}

Findings read_team(const input::Document& document) {
  Section section{document, "team"};
  Findings all;
  const input::TomlNode table = document.root()["team"];
  for (const std::string& key : table.keys()) {
    std::optional<Known> known;
    if (const auto number = table[key].number()) {
      known = Number{*number, *number};
    } else if (const auto flag = table[key].flag()) {
      known = *flag;
    } else {
      known = section.text(key);
    }
    all["team." + key] = {std::move(known), "stated in the pack"};
  }
  return all;
}

void check_hash(Section& section, const std::string& hash) {
  const bool is_hex = hash.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!hash.empty() && (hash.size() != 64 || !is_hex)) {
    section.refuse("document_sha256",
                   fmt::format("= \"{}\"; allowed: \"\", or 64 digits as sha256sum prints them", hash));
  }
}

}  // namespace

std::string_view name(Kind kind) { return kind_names.at(static_cast<std::size_t>(kind)); }

Pack read_pack(const input::Document& document) {
  const std::vector<std::string> known{"title", "date", "document", "document_sha256", "notes", "team", "clauses"};
  input::refuse_unknown_sections(document, known);
  Section head{document, ""};
  Pack pack{.name = input::name_of_file(document.file()), .file = document.file()};
  pack.title = text_of(head, "title");
  pack.date = text_of(head, "date");
  pack.document = text_of(head, "document");
  pack.document_sha256 = head.text("document_sha256");
  check_hash(head, pack.document_sha256);
  pack.notes = head.texts("notes", most_texts);
  pack.team = read_team(document);
  const auto tables = document.root()["clauses"].elements();
  if (!tables || tables->empty()) {
    head.refuse("clauses", "is missing; allowed: [[clauses]], once for each clause");
  }
  const Names names{pack.team};
  std::set<std::string> ids;
  for (const input::TomlNode& table : *tables) {
    if (!table.is_table()) {
      head.refuse("clauses", "= " + table.as_text() + " is not a table; allowed: [[clauses]], once for each clause");
    }
    pack.clauses.push_back(read_clause(document, table, names));
    if (!ids.insert(pack.clauses.back().id).second) {
      const Section section{document, "clauses", table};
      section.refuse("id", fmt::format("= \"{}\" is the id of an earlier clause, too", pack.clauses.back().id));
    }
  }
  return pack;
}

Pack load_pack(const std::string& name_or_path) {
  return read_pack(input::Document::load(input::find_input(input::Shipped::rules, name_or_path)));
}

}  // namespace fantail::rules
