// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "campaign/results.hpp"
#include "text/number.hpp"

// What the figures of the runs depend on, as it is shown.
namespace fantail::campaign {
namespace {

using Json = json::Value;
using result::Cell;

/// How much the slopes explain, and what they do not show.
std::string about_slopes(const Analysis& analysis) {
  const std::size_t figure = analysis.question.measured_by();
  const bool all_known =
      std::ranges::all_of(analysis.influences, [figure](const auto& of) { return of.slopes[figure].has_value(); });
  return fmt::format(
      "A linear fit of all quantities together explains {} % of the variance. Slopes do not show curves, thresholds, "
      "or combined effects of two quantities.{}",
      text::fixed(100.0 * std::max(0.0, analysis.explained), 0),
      all_known ? ""
                : " A slope is not known if the quantity does not vary, if quantities depend wholly on each other, or "
                  "if one run alone decides.");
}

Cell slope_cell(const std::optional<Estimate>& slope) {
  return result::Digits{slope ? fmt::format("{} ({} to {})", text::fixed(slope->value, 2), text::fixed(slope->low, 2),
                                            text::fixed(slope->high, 2))
                              : "not known"};
}

result::Column words_column(const std::string& label) { return {.key = label, .label = label}; }

}  // namespace

std::vector<result::Block> influences(const Report& report) {
  const Analysis& a = report.analysis;
  const std::size_t figure = a.question.measured_by();
  if (!a.no_influences.empty()) {
    return {a.no_influences};
  }
  result::Table slopes{.columns = {words_column("quantity"), words_column("slope, standard deviations")}};
  for (const QuantityInfluence& of : a.influences) {
    slopes.rows.push_back({result::Named{of.name, column_words(of.name).words}, slope_cell(of.slopes[figure])});
  }
  std::vector<result::Block> all{
      fmt::format("How the {} depends on each drawn quantity, from {}, with 95 % intervals.",
                  column_words(figure_columns[figure]).words, text::counted(a.influence_runs, "run")),
      result::Drawing{tornado_svg(report, page::full_page), tornado_svg(report, page::half_page),
                      "The line at the end of each bar is its 95 % interval."},
      slopes,
      "Slope: change of the figure, in its standard deviations, per standard deviation of the quantity, with the "
      "others held. " +
          about_slopes(a)};
  for (std::size_t i = 0; i < std::min<std::size_t>(2, a.influences.size()); ++i) {
    all.emplace_back(result::Picture{scatter(report, a.influences[i].name)});
  }
  return all;
}

result::Table slopes_of_each_figure(const Analysis& a) {
  result::Table table{.columns = {words_column("quantity")}};
  for (const QuantityInfluence& of : a.influences) {
    table.rows.push_back({column_words(of.name).words});
  }
  for (std::size_t i = 0; i < figure_columns.size(); ++i) {
    if (std::ranges::any_of(a.influences, [i](const auto& of) { return of.slopes[i].has_value(); })) {
      table.columns.push_back({.key = std::string{figure_columns[i]},
                               .label = column_words(figure_columns[i]).words,
                               .decimals = 2,
                               .absent = ""});
      for (std::size_t j = 0; j < a.influences.size(); ++j) {
        const auto& slope = a.influences[j].slopes[i];
        table.rows[j].push_back(slope ? Cell{slope->value} : Cell{});
      }
    }
  }
  return table.columns.size() == 1 ? result::Table{} : table;
}

json::Value influences_for_programs(const Analysis& a) {
  Json of = Json::array();
  for (const QuantityInfluence& quantity : a.influences) {
    Json slopes;
    Json shares;  // no longer estimated; the keys stay for who reads them
    for (std::size_t i = 0; i < figure_columns.size(); ++i) {
      const auto& slope = quantity.slopes[i];
      slopes[figure_columns[i]] = slope ? Json{json::rounded(slope->value)} : Json{};
      shares[figure_columns[i]] = Json{};
    }
    const auto& e = quantity.slopes[a.question.measured_by()];
    of.push_back(
        {{"name", quantity.name},
         {"slope",
          e ? Json{{"value", json::rounded(e->value)}, {"low", json::rounded(e->low)}, {"high", json::rounded(e->high)}}
            : Json{}},
         {"slope_of", slopes},
         {"variance_share", Json{}},
         {"variance_share_of", shares}});
  }
  return {{"figure", figure_columns[a.question.measured_by()]},
          {"runs", a.influence_runs},
          {"explained_by_straight_lines", a.no_influences.empty() ? Json{json::rounded(a.explained)} : Json{}},
          {"why_none", json::text_or_null(a.no_influences)},
          {"why_no_variance_share",
           "No estimator tried held the true share in 93 to 97 % of its intervals, so shares are no longer given. Use "
           "slope."},
          {"of", of}};
}

}  // namespace fantail::campaign
