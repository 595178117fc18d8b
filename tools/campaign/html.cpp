// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "campaign/charts.hpp"
#include "campaign/column_words.hpp"
#include "campaign/results.hpp"
#include "campaign/setup.hpp"
#include "page/page.hpp"
#include "text/number.hpp"

namespace fantail::campaign {
namespace {

using text::fixed;

page::Tone tone(const std::optional<Judgement>& judgement) {
  if (!judgement) {
    return page::Tone::plain;
  }
  switch (*judgement) {
    case Judgement::met: return page::Tone::good;
    case Judgement::not_met: return page::Tone::bad;
    case Judgement::undecided: break;
  }
  return page::Tone::unsure;
}

std::string heading(const std::optional<Judgement>& judgement) {
  if (!judgement) {
    return "Found";
  }
  return *judgement == Judgement::met ? "Met" : *judgement == Judgement::not_met ? "Not met" : "Not decided";
}

std::string outcomes(const Report& report) {
  const std::array<page::Column, 3> columns{{{"outcome"}, {"runs", true}, {"%", true}}};
  std::vector<std::vector<page::Cell>> rows;
  for (const auto& [name, count] : report.analysis.outcomes) {
    const double share = static_cast<double>(count) / static_cast<double>(report.analysis.share.of);
    rows.push_back({{outcome_words(name)}, {fmt::format("{}", count)}, {fixed(100.0 * share, 2)}});
  }
  return page::table(columns, rows);
}

std::string columns_table(const std::vector<Column>& list) {
  const std::array<page::Column, 7> columns{
      {{""}, {"runs", true}, {"least", true}, {"5 %", true}, {"median", true}, {"95 %", true}, {"largest", true}}};
  std::vector<std::vector<page::Cell>> rows;
  const auto number = [](double value) { return page::Cell{fmt::format("{:.5g}", value)}; };
  for (const Column& c : list) {
    rows.push_back({{.text = column_words(c.name).with_unit(), .below = c.name},
                    {fmt::format("{}", c.values.size())},
                    number(c.least),
                    number(c.quantiles.p5),
                    number(c.quantiles.p50),
                    number(c.quantiles.p95),
                    number(c.largest)});
  }
  return page::table(columns, rows);
}

std::string distributions(const Report& report) {
  std::string text;
  std::vector<std::string> plots;
  const auto flush = [&] {
    text += plots.empty() ? "" : page::side_by_side(plots);
    plots.clear();
  };
  for (const Column& c : report.analysis.figures) {
    if (c.largest > c.least) {
      plots.push_back(page::figure(histogram(c)));
    }
    if (plots.size() == 2) {
      flush();
    }
  }
  flush();
  return text + columns_table(report.analysis.figures);
}

std::string with_interval(const Estimate& e, double scale, int decimals) {
  return fmt::format("{} ({} to {})", fixed(scale * e.value, decimals), fixed(scale * e.low, decimals),
                     fixed(scale * e.high, decimals));
}

std::string influences(const Report& report) {
  const Analysis& a = report.analysis;
  const std::size_t figure = a.question.measured_by();
  if (!a.no_influences.empty()) {
    return page::paragraph(a.no_influences);
  }
  const std::array<page::Column, 3> columns{
      {{"quantity"}, {"share of the variance, %", true}, {"slope, standard deviations", true}}};
  std::vector<std::vector<page::Cell>> rows;
  for (const QuantityInfluence& of : a.influences) {
    if (of.variance_shares[figure]) {
      const auto& slope = of.on_result.slope;
      rows.push_back({{column_words(of.name).words},
                      {with_interval(of.on_result.variance_share, 100.0, 1)},
                      {slope ? with_interval(*slope, 1.0, 2) : "depends on others"}});
    }
  }
  const std::array<std::string, 2> plots{
      page::figure(scatter(report, a.influences.front().name)),
      page::figure(scatter(report, a.influences[std::min<std::size_t>(1, a.influences.size() - 1)].name))};
  return page::paragraph(fmt::format("What the {} depends on, by {} runs, with 95 % intervals.",
                                     column_words(figure_columns[figure]).words, a.influence_runs)) +
         page::table(columns, rows) +
         page::note(fmt::format(
             "Share of the variance: what would go if this quantity alone were known (Sobol's index of first order), "
             "estimated, so that a small one may come out below 0. "
             "Slope: by how many of its standard deviations the figure moves with one of the quantity's, the others "
             "held; straight lines of all quantities together explain {} % of the variance.",
             fixed(100.0 * a.explained, 0))) +
         (a.influences.size() > 1 ? page::side_by_side(plots) : plots[0]);
}

/// Of every figure, the share of its variance by quantity.
std::string all_influences(const Analysis& a) {
  std::vector<page::Column> columns{{"share of the variance, %"}};
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < figure_columns.size(); ++i) {
    if (std::ranges::any_of(a.influences, [i](const auto& of) { return of.variance_shares[i].has_value(); })) {
      columns.push_back({column_words(figure_columns[i]).words, true});
      shown.push_back(i);
    }
  }
  std::vector<std::vector<page::Cell>> rows;
  for (const QuantityInfluence& of : a.influences) {
    rows.push_back({{column_words(of.name).words}});
    for (const std::size_t i : shown) {
      const auto& share = of.variance_shares[i];
      rows.back().push_back({share ? fixed(std::max(0.0, 100.0 * *share), 0) : ""});
    }
  }
  return shown.empty() ? "" : page::table(columns, rows);
}

std::string worst(const Report& report) {
  std::vector<page::Link> links;
  for (std::size_t i = 0; i < report.analysis.worst.size(); ++i) {
    const FlownRun& run = report.flown.runs[report.analysis.worst[i]];
    const std::size_t figure = report.analysis.question.measured_by();
    const ColumnWords asked = column_words(figure_columns[figure]);
    const std::string& folder = report.run_folders[i];
    const std::string value = run.figures[figure] ? fmt::format(", {} {:.5g}{}{}", asked.words, *run.figures[figure],
                                                                asked.unit.empty() ? "" : " ", asked.unit)
                                                  : "";
    links.push_back({.href = folder.empty() ? "" : folder + "/report.html",
                     .text = fmt::format("run {}", run.run),
                     .about = fmt::format(": {}{}{}{}", outcome_words(run.outcome), value, run.note.empty() ? "" : "; ",
                                          run.note)});
  }
  return page::list(links) + page::paragraph("Any run again, with its flight report: " + report.run_command + " RUN");
}

}  // namespace

std::string report_html(const Report& report) {
  const FlownCampaign& flown = report.flown;
  const Campaign& campaign = report.campaign;
  std::string changes;
  for (const input::Override& change : campaign.changes) {
    changes += (changes.empty() ? ". Changed: " : ", ") + lines_of({change});
  }
  return page::html(
      {.kind = "Fantail campaign",
       .title = flown.scenario,
       .subtitle = fmt::format("{}, plan {}; {} runs, {}, seed {}; Fantail {}{}", flown.vehicle, flown.plan,
                               flown.runs.size(), sampling_names[static_cast<std::size_t>(campaign.sampling)],
                               campaign.seed, report.version, changes),
       .tone = tone(report.analysis.judgement),
       .verdict_heading = heading(report.analysis.judgement),
       .verdict = headline(report),
       .body_html = page::section("Outcomes", outcomes(report) + page::figure(convergence_chart(report))) +
                    page::section("Figures of the runs", distributions(report)) +
                    page::section("What matters", influences(report) + all_influences(report.analysis)) +
                    page::section("The worst runs", worst(report)) +
                    page::section("What was drawn", columns_table(report.analysis.quantities)) +
                    page::section("How far this can be trusted", page::list(remarks(report))) +
                    page::section("Again", page::paragraph(report.command))});
}

}  // namespace fantail::campaign
