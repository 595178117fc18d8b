// SPDX-License-Identifier: MIT
#include "campaign/results.hpp"
#include "campaign/setup.hpp"
#include "json/value.hpp"

namespace fantail::campaign {
namespace {

using Json = json::Value;
using json::rounded;

Json json(const Column& c) {
  return {{"name", c.name},
          {"runs", c.values.size()},
          {"mean", rounded(c.quantiles.mean)},
          {"least", rounded(c.least)},
          {"p5", rounded(c.quantiles.p5)},
          {"p50", rounded(c.quantiles.p50)},
          {"p95", rounded(c.quantiles.p95)},
          {"largest", rounded(c.largest)}};
}

Json json(const Estimate& e) {
  return {{"value", rounded(e.value)}, {"low", rounded(e.low)}, {"high", rounded(e.high)}};
}

Json columns(const std::vector<Column>& list) {
  Json all = Json::array();
  for (const Column& c : list) {
    all.push_back(json(c));
  }
  return all;
}

constexpr std::string_view why_no_variance_share =
    "No estimator tried held the true share in 93 to 97 % of its intervals, so shares are no longer given. Use slope.";

Json influences(const Analysis& a) {
  Json of = Json::array();
  for (const QuantityInfluence& quantity : a.influences) {
    Json slopes;
    Json shares;  // no longer estimated; the keys stay for who reads them
    for (std::size_t i = 0; i < figure_columns.size(); ++i) {
      const auto& slope = quantity.slopes[i];
      slopes[figure_columns[i]] = slope ? Json{rounded(slope->value)} : Json{};
      shares[figure_columns[i]] = Json{};
    }
    const auto& slope = quantity.slopes[a.question.measured_by()];
    of.push_back({{"name", quantity.name},
                  {"slope", slope ? json(*slope) : Json{}},
                  {"slope_of", slopes},
                  {"variance_share", Json{}},
                  {"variance_share_of", shares}});
  }
  return {{"figure", figure_columns[a.question.measured_by()]},
          {"runs", a.influence_runs},
          {"explained_by_straight_lines", a.no_influences.empty() ? Json{rounded(a.explained)} : Json{}},
          {"why_none", json::text_or_null(a.no_influences)},
          {"why_no_variance_share", why_no_variance_share},
          {"of", of}};
}

Json worst(const Report& report) {
  Json all = Json::array();
  for (std::size_t i = 0; i < report.analysis.worst.size(); ++i) {
    const FlownRun& run = report.flown.runs[report.analysis.worst[i]];
    all.push_back({{"run", run.run},
                   {"seed", run.seed},
                   {"outcome", run.outcome},
                   {"value", rounded(run.figures[report.analysis.question.measured_by()])},
                   {"note", json::text_or_null(run.note)},
                   {"folder", json::text_or_null(report.run_folders[i])}});
  }
  return all;
}

constexpr std::string_view name(Judgement judgement) {
  switch (judgement) {
    case Judgement::met: return "met";
    case Judgement::not_met: return "not_met";
    case Judgement::undecided: break;
  }
  return "undecided";
}

}  // namespace

std::string report_json(const Report& report) {
  const Analysis& a = report.analysis;
  const Campaign& campaign = report.campaign;
  Json outcomes;
  for (const auto& [outcome, count] : a.outcomes) {
    outcomes[outcome] = Json{count};
  }
  Json changes = Json::array();
  for (const input::Override& change : campaign.changes) {
    changes.push_back(lines_of({change}));
  }
  Json all{{"scenario", report.flown.scenario},
           {"vehicle", report.flown.vehicle},
           {"plan", report.flown.plan},
           {"changes", changes},
           {"version", report.made.version},
           {"seed", campaign.seed},
           {"sampling", "independent"},
           {"runs", report.flown.runs.size()},
           {"runs_asked", campaign.runs},
           {"stop", campaign.stop ? Json{campaign.stop->text()} : Json{}},
           {"question", a.question.text()},
           {"share",
            {{"count", a.share.count},
             {"of", a.share.of},
             {"share", rounded(a.share.value)},
             {"low", rounded(a.share.low)},
             {"high", rounded(a.share.high)},
             {"interval", a.by_sequence ? "confidence_sequence" : "wilson"}}},
           {"required_share", rounded(a.required)},
           {"judgement", a.judgement ? Json{name(*a.judgement)} : Json{}},
           {"remarks", remarks(report)},
           {"outcomes", outcomes},
           {"runs_outside_model", runs_outside_the_model(report)},
           {"runs_drawn_again", a.drawn_again},
           {"figures", columns(a.figures)},
           {"quantities", columns(a.quantities)},
           {"influences", influences(a)},
           {"worst_runs", worst(report)}};
  json::keep_exact(all, "seed");
  result::put_answer(all, answer(report), headline(report), report.made);
  return all.pretty();
}

}  // namespace fantail::campaign
