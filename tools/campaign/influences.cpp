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
std::string about_slopes(const Analysis& analysis, std::size_t figure) {
  const bool all_known =
      std::ranges::all_of(analysis.influences, [figure](const auto& of) { return of.slopes[figure].has_value(); });
  const Fit& fit = analysis.fits[figure];
  return fmt::format(
      "A linear fit of all quantities together explains {} % of the variance{}.{}",
      text::fixed(100.0 * std::max(0.0, fit.explained), 0),
      explains_little(fit) ? ", less than 10 %: these slopes do not explain the figure" : "",
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

/// "Criterion: the tilt limit ended control early (12 runs). ": why this figure is shown.
std::string why_shown(const Analysis& analysis, std::size_t figure) {
  std::string all;
  for (const Failure& failure : analysis.failures) {
    if (failure.criterion->figure == figure) {
      all += fmt::format("{}{} ({})", all.empty() ? "" : "; ", failure.criterion->words,
                         text::counted(failure.runs, "run"));
    }
  }
  return all.empty() ? "" : fmt::format("Criterion: {}. ", all);
}

void add_figure(std::vector<result::Block>& all, const Report& report, std::size_t figure) {
  const Analysis& a = report.analysis;
  if (!a.fits[figure].why_none.empty()) {
    all.emplace_back(why_shown(a, figure) + a.fits[figure].why_none);
    return;
  }
  result::Table slopes{.columns = {words_column("quantity"), words_column("slope, standard deviations")}};
  for (const QuantityInfluence& of : steepest_first(a.influences, figure)) {
    slopes.rows.push_back({result::Named{of.name, column_words(of.name).words}, slope_cell(of.slopes[figure])});
  }
  all.emplace_back(fmt::format("{}How the {} depends on each drawn quantity, from {}, with 95 % intervals.",
                               why_shown(a, figure), column_words(figure_columns[figure]).words,
                               text::counted(a.fits[figure].runs, "run")));
  all.emplace_back(result::Drawing{tornado_svg(report, figure, page::full_page),
                                   tornado_svg(report, figure, page::half_page),
                                   "The line at the end of each bar is its 95 % interval."});
  all.emplace_back(slopes);
  all.emplace_back(about_slopes(a, figure));
}

}  // namespace

std::vector<result::Block> influences(const Report& report) {
  const Analysis& a = report.analysis;
  if (a.decided_by.empty()) {
    return {
        fmt::format("Most runs that fail, fail by this criterion: {}. No figure measures it, so influences are not "
                    "known.",
                    a.failures.front().criterion->words)};
  }
  std::vector<result::Block> all;
  if (a.question.relation == Relation::is && a.failures.empty()) {
    all.emplace_back(a.share.of == a.share.count
                         ? "Every run is held, so no criterion decides. The largest hold error is shown."
                         : "No run fails, so no criterion decides. The largest hold error is shown.");
  }
  bool has_slopes = false;
  for (const std::size_t figure : a.decided_by) {
    add_figure(all, report, figure);
    has_slopes = has_slopes || a.fits[figure].why_none.empty();
  }
  if (has_slopes) {
    all.emplace_back(
        "Slope: change of the figure, in its standard deviations, per standard deviation of the quantity, with the "
        "others held. Slopes do not show curves, thresholds, or combined effects of two quantities.");
  }
  std::string unmeasured;
  for (const Failure& failure : a.failures) {
    if (!failure.criterion->figure) {
      unmeasured += (unmeasured.empty() ? "" : "; ") + std::string{failure.criterion->words};
    }
  }
  if (!unmeasured.empty()) {
    all.emplace_back(
        fmt::format("No figure measures these criteria, so their influences are not known: {}.", unmeasured));
  }
  const std::size_t main = a.decided_by.front();
  for (std::size_t i = 0; i < std::min<std::size_t>(2, a.influences.size()) && a.fits[main].why_none.empty(); ++i) {
    all.emplace_back(
        result::Picture{scatter(report, main, a.influences[i].name),
                        explains_little(a.fits[main]) ? "Straight lines explain less than 10 % of it." : ""});
  }
  return all;
}

result::Table slopes_of_other_figures(const Analysis& a) {
  result::Table table{.columns = {words_column("quantity")}};
  for (const QuantityInfluence& of : a.influences) {
    table.rows.push_back({column_words(of.name).words});
  }
  for (std::size_t i = 0; i < figure_columns.size(); ++i) {
    const bool is_shown = std::ranges::find(a.decided_by, i) != a.decided_by.end() && a.fits[i].why_none.empty();
    if (!is_shown && std::ranges::any_of(a.influences, [i](const auto& of) { return of.slopes[i].has_value(); })) {
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
  const std::size_t* const figure = a.decided_by.empty() ? nullptr : &a.decided_by.front();
  const Fit fit =
      figure != nullptr ? a.fits[*figure] : Fit{.why_none = "No figure measures the criterion that the runs fail."};
  Json of = Json::array();
  for (const QuantityInfluence& quantity : a.influences) {
    Json slopes;
    Json shares;  // no longer estimated; the keys stay for who reads them
    for (std::size_t i = 0; i < figure_columns.size(); ++i) {
      const auto& slope = quantity.slopes[i];
      slopes[figure_columns[i]] = slope ? Json{json::rounded(slope->value)} : Json{};
      shares[figure_columns[i]] = Json{};
    }
    const auto slope_json = [](const Estimate& slope) {
      return Json{{"value", json::rounded(slope.value)},
                  {"low", json::rounded(slope.low)},
                  {"high", json::rounded(slope.high)}};
    };
    const bool is_known = figure != nullptr && quantity.slopes[*figure].has_value();
    of.push_back({{"name", quantity.name},
                  {"slope", is_known ? slope_json(*quantity.slopes[*figure]) : Json{}},
                  {"slope_of", slopes},
                  {"variance_share", Json{}},
                  {"variance_share_of", shares}});
  }
  return {{"figure", figure != nullptr ? Json{figure_columns[*figure]} : Json{}},
          {"runs", fit.runs},
          {"explained_by_straight_lines", fit.why_none.empty() ? Json{json::rounded(fit.explained)} : Json{}},
          {"why_none", json::text_or_null(fit.why_none)},
          {"why_no_variance_share",
           "No estimator tried held the true share in 93 to 97 % of its intervals, so shares are no longer given. Use "
           "slope."},
          {"of", of}};
}

}  // namespace fantail::campaign
