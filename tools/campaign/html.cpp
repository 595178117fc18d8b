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

std::string with_interval(const Estimate& e) {
  return fmt::format("{} ({} to {})", fixed(e.value, 2), fixed(e.low, 2), fixed(e.high, 2));
}

std::string influences(const Report& report) {
  const Analysis& a = report.analysis;
  const std::size_t figure = a.question.measured_by();
  if (!a.no_influences.empty()) {
    return page::paragraph(a.no_influences);
  }
  const std::array<page::Column, 2> columns{{{"quantity"}, {"slope, standard deviations", true}}};
  std::vector<std::vector<page::Cell>> rows;
  for (const QuantityInfluence& of : a.influences) {
    const auto& slope = of.slopes[figure];
    rows.push_back({{column_words(of.name).words}, {slope ? with_interval(*slope) : std::string{no_slope}}});
  }
  const std::array<std::string, 2> plots{
      page::figure(scatter(report, a.influences.front().name)),
      page::figure(scatter(report, a.influences[std::min<std::size_t>(1, a.influences.size() - 1)].name))};
  return page::paragraph(fmt::format("What the {} depends on, by {} runs, with 95 % intervals.",
                                     column_words(figure_columns[figure]).words, a.influence_runs)) +
         page::table(columns, rows) +
         page::note(
             "Slope: by how many of its standard deviations the figure moves with one of the quantity's, the "
             "others held. " +
             about_slopes(a)) +
         (a.influences.size() > 1 ? page::side_by_side(plots) : plots[0]);
}

/// Of every figure, its slope by each quantity.
std::string all_influences(const Analysis& a) {
  std::vector<page::Column> columns{{"slope of each figure"}};
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < figure_columns.size(); ++i) {
    if (std::ranges::any_of(a.influences, [i](const auto& of) { return of.slopes[i].has_value(); })) {
      columns.push_back({column_words(figure_columns[i]).words, true});
      shown.push_back(i);
    }
  }
  std::vector<std::vector<page::Cell>> rows;
  for (const QuantityInfluence& of : a.influences) {
    rows.push_back({{column_words(of.name).words}});
    for (const std::size_t i : shown) {
      const auto& slope = of.slopes[i];
      rows.back().push_back({slope ? fixed(slope->value, 2) : ""});
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
       .subtitle = fmt::format("{}, plan {}; {} runs, independent, seed {}; Fantail {}{}", flown.vehicle, flown.plan,
                               flown.runs.size(), campaign.seed, report.made.version, changes),
       .tone = result::tone(answer(report)),
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
