// SPDX-License-Identifier: MIT
#include "fantail/plan_rules.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "fantail/run.hpp"
#include "fantail/terminal.hpp"
#include "result/answer.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

bool is_bad(const rules::Judged& one) {
  return one.outcome == rules::Outcome::fail || one.outcome == rules::Outcome::not_known;
}

}  // namespace

PlanRules::PlanRules(const std::optional<std::string>& pack, const std::filesystem::path& file,
                     const core::FlightPlan& plan)
    : file_{file} {
  if (pack) {
    pack_ = rules::load_pack(*pack);
    rules::Subject subject{.what = file.string(),
                           .found = rules::of_plan(plan),
                           .why_missing = "a plan does not tell it",
                           .plan_alone = true};
    subject.found.merge(rules::of_law());
    judged_ = rules::judge(*pack_, subject);
  }
}

bool PlanRules::fails() const { return std::ranges::any_of(judged_, is_bad); }

void PlanRules::show() const {
  tool::show("{}: rules {}: {} {}\n", text::printable(file_.string()), pack_->name,
             text::printable(rules::verdict(judged_).sentence), text::printable(rules::caution(*pack_)));
  for (const rules::Judged& one : judged_) {
    if (is_bad(one)) {
      tool::show("  {} {}: {} {}\n", rules::name(one.outcome), text::printable(one.clause.id),
                 text::printable(one.clause.words), text::printable(fmt::format("{}", fmt::join(one.evidence, "; "))));
    }
  }
}

json::Value PlanRules::added_to(json::Value all) const {
  if (!pack_) {
    return all;
  }
  json::Value clauses = json::Value::array();
  for (const rules::Judged& one : judged_) {
    std::string outcome{rules::name(one.outcome)};
    std::ranges::replace(outcome, ' ', '_');
    clauses.push_back(json::Value{{"id", one.clause.id}, {"outcome", outcome}, {"evidence", one.evidence}});
  }
  const std::string sentence = rules::verdict(judged_).sentence;
  all["rules"] = json::Value{{"pack", pack_->name}, {"sentence", sentence}, {"caution", rules::caution(*pack_)}};
  all["rules"]["clauses"] = std::move(clauses);
  if (fails()) {
    all["answer"] = std::string{result::name(result::Answer::no)};
    all["sentence"] = sentence;
  }
  return all;
}

void PlanRules::end(bool shows) const {
  if (pack_ && shows) {
    show();
  }
  if (fails()) {
    throw RequirementNotMet{""};
  }
}

}  // namespace fantail::tool
