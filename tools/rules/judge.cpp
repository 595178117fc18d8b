// SPDX-License-Identifier: MIT
#include "rules/judge.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

namespace fantail::rules {
namespace {

bool names_any_of(const Clause& clause, std::string_view room) {
  return std::ranges::any_of(
      std::array{&clause.applies_if, &clause.passes_if, &clause.fails_if}, [&](const auto* expression) {
        return *expression && std::ranges::any_of((*expression)->names(),
                                                  [&](const std::string& name) { return name.starts_with(room); });
      });
}

class Judge {
 public:
  Judge(const Pack& pack, const Subject& subject) : pack_{pack}, subject_{subject} {}

  [[nodiscard]] Judged operator()(const Clause& clause) const {
    const Outcome found = outcome(clause);
    return {.clause = clause,
            .outcome = found,
            .evidence = found == Outcome::not_judged ? std::vector<std::string>{} : evidence(clause)};
  }

 private:
  [[nodiscard]] Finding finding(const std::string& name) const {
    for (const Findings* all : {&subject_.found, &pack_.team}) {
      if (const auto found = all->find(name); found != all->end()) {
        return found->second;
      }
    }
    return {{}, subject_.why_missing};
  }

  [[nodiscard]] std::optional<bool> value(const Expression& expression) const {
    const auto known = expression.value([this](const std::string& name) { return finding(name).known; });
    return known ? std::optional{std::get<bool>(*known)} : std::nullopt;
  }

  [[nodiscard]] Outcome outcome(const Clause& clause) const {
    if (subject_.plan_alone && (names_any_of(clause, "flight.") || names_any_of(clause, "rocket."))) {
      return Outcome::not_judged;
    }
    const std::optional<bool> applies = clause.applies_if ? value(*clause.applies_if) : std::optional{true};
    if (!applies) {
      return Outcome::not_known;
    }
    if (!*applies) {
      return Outcome::not_applicable;
    }
    if (!clause.passes_if) {
      const std::optional<bool> fails = clause.fails_if ? value(*clause.fails_if) : std::optional{false};
      return !fails ? Outcome::not_known : *fails ? Outcome::fail : Outcome::blank;
    }
    const std::optional<bool> passes = value(*clause.passes_if);
    return !passes ? Outcome::not_known : *passes ? Outcome::pass : Outcome::fail;
  }

  [[nodiscard]] std::vector<std::string> evidence(const Clause& clause) const {
    std::vector<std::string> all;
    std::set<std::string> said;
    const auto add = [&](const std::vector<std::string>& names) {
      for (const std::string& name : names) {
        if (said.insert(name).second) {
          const auto [known, how] = finding(name);
          all.push_back(fmt::format("{} = {}{}", name, value_text(name, known), how.empty() ? "" : " (" + how + ")"));
        }
      }
    };
    for (const auto* expression : {&clause.applies_if, &clause.passes_if, &clause.fails_if}) {
      if (*expression) {
        add((*expression)->deciding_names([this](const std::string& name) { return finding(name).known; }));
      }
    }
    add(clause.evidence);
    return all;
  }

  const Pack& pack_;
  const Subject& subject_;
};

/// "2 not known (7.1, 7.3)"
std::string counted_as(const std::vector<Judged>& judged, Outcome outcome, std::string_view words) {
  std::size_t count = 0;
  std::string ids;
  for (const Judged& one : judged) {
    if (one.outcome == outcome) {
      ids += (count++ == 0 ? "" : "; ") + one.clause.id;
    }
  }
  return count == 0 ? "" : fmt::format("{} {} ({})", count, words, ids);
}

std::string joined(const std::vector<std::string>& parts) {
  std::string all;
  for (const std::string& part : parts) {
    all += part.empty() ? "" : (all.empty() ? "" : ", ") + part;
  }
  return all;
}

}  // namespace

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::pass: return "PASS";
    case Outcome::fail: return "FAIL";
    case Outcome::blank: return "BLANK";
    case Outcome::not_applicable: return "NOT APPLICABLE";
    case Outcome::not_known: return "NOT KNOWN";
    case Outcome::not_judged: break;
  }
  return "NOT JUDGED";
}

std::vector<Judged> judge(const Pack& pack, const Subject& subject) {
  std::vector<Judged> all;
  std::ranges::transform(pack.clauses, std::back_inserter(all), Judge{pack, subject});
  return all;
}

result::Verdict verdict(const std::vector<Judged>& judged) {
  const auto count = [&](Outcome outcome) { return std::ranges::count(judged, outcome, &Judged::outcome); };
  const auto fails = count(Outcome::fail);
  const auto unknown = count(Outcome::not_known);
  const auto passes = count(Outcome::pass);
  const std::string of = fmt::format("of {} {}", judged.size(), judged.size() == 1 ? "clause" : "clauses");
  std::string sentence = fmt::format("{} {} pass", passes, of);
  if (fails > 0) {
    std::string ids = counted_as(judged, Outcome::fail, "");
    ids = ids.substr(ids.find('(') + 1);
    ids.pop_back();
    sentence = fmt::format("{} {} {}: {}; {} {}", fails, of, fails == 1 ? "fails" : "fail", ids, passes,
                           passes == 1 ? "passes" : "pass");
  } else if (passes == 1) {
    sentence += "es";
  }
  sentence += ".";
  const std::string rest = joined({counted_as(judged, Outcome::blank, "for the team to show"),
                                   counted_as(judged, Outcome::not_known, "not known"),
                                   counted_as(judged, Outcome::not_applicable, "not applicable"),
                                   counted_as(judged, Outcome::not_judged, "that need a flight")});
  sentence += rest.empty() ? " Every clause was judged." : " Not judged: " + rest + ".";
  const bool decided = unknown == 0 && passes > 0;
  return {.answer = fails > 0 ? result::Answer::no
                    : decided ? result::Answer::yes
                              : result::Answer::undecided,
          .heading = fails > 0 ? "Fails"
                     : decided ? "No clause fails"
                               : "Not decided",
          .sentence = sentence,
          .with_caution = passes < static_cast<std::ptrdiff_t>(judged.size())};
}

result::Verdict verdict(const std::vector<Judged>& judged, const Subject& subject) {
  result::Verdict found = verdict(judged);
  const bool lacks_rocket = std::ranges::any_of(judged, [](const Judged& one) {
    return one.outcome == Outcome::not_known &&
           (names_any_of(one.clause, "rocket.") || names_any_of(one.clause, "flight.burnout_s"));
  });
  if (lacks_rocket && !subject.no_rocket.empty()) {
    found.sentence += fmt::format(" The rocket is not known: {}.", subject.no_rocket);
  }
  return found;
}

std::string caution(const Pack& pack) {
  return fmt::format("Check against the current document ({}). These are our words of {}, and no legal advice. {}",
                     pack.document, pack.date,
                     pack.document_sha256.empty()
                         ? "Nobody has compared them with that document."
                         : "Somebody compared them with the document of SHA-256 " + pack.document_sha256 + ".");
}

}  // namespace fantail::rules
