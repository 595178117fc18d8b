// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/core.h>

#include "campaign/results.hpp"
#include "page/page.hpp"
#include "page/svg_plot.hpp"

namespace fantail::campaign {
namespace {

using page::Mark;
using page::Role;

constexpr std::size_t most_points = 2'000;  // of a scatter: the page stays small, and more are one cloud

/// Bins as Freedman and Diaconis choose them, with the middle half that a normal law of these ends has, within what can
/// be seen.
std::size_t bins_of(const Column& column) {
  constexpr double fewest = 8.0;
  constexpr double most = 60.0;
  const double middle_half = 0.41 * (column.quantiles.p95 - column.quantiles.p5);
  const double width = 2.0 * middle_half / std::cbrt(static_cast<double>(column.values.size()));
  const double bins = width > 0.0 ? (column.largest - column.least) / width : most;
  return static_cast<std::size_t>(std::clamp(bins, fewest, most));
}

}  // namespace

page::Chart convergence_chart(const Report& report) {
  const Analysis& a = report.analysis;
  page::Series share{.name = "share so far", .role = Role::measured};
  page::Area bounds{.name = "95 % bounds that hold at every look", .role = Role::measured};
  for (const Looked& at : a.looked) {
    share.x.push_back(static_cast<double>(at.runs));
    share.y.push_back(100.0 * at.share);
    bounds.x.push_back(static_cast<double>(at.runs));
    bounds.low.push_back(100.0 * at.bounds.low);
    bounds.high.push_back(100.0 * at.bounds.high);
  }
  page::Chart chart{.label = "Share of the runs that meet the question, over their number",
                    .x_label = "runs",
                    .y_label = a.question.words() + " / %",
                    .series = {share},
                    .areas = {bounds}};
  if (a.required) {
    chart.levels.push_back({.value = 100.0 * *a.required, .label = "required", .role = Role::limit});
  }
  return chart;
}

page::Chart histogram(const Column& column) {
  const std::size_t bins = bins_of(column);
  const double width = (column.largest - column.least) / static_cast<double>(bins);
  std::vector<double> counts(bins, 0.0);
  for (const double value : column.values) {
    counts[std::min(bins - 1, static_cast<std::size_t>((value - column.least) / width))] += 1.0;
  }
  page::Series outline{.name = "runs", .role = Role::measured, .mark = Mark::step};
  for (std::size_t i = 0; i <= bins; ++i) {
    outline.x.push_back(column.least + width * static_cast<double>(i));
    outline.y.push_back(i < bins ? counts[i] : 0.0);
  }
  outline.x.insert(outline.x.begin(), column.least);
  outline.y.insert(outline.y.begin(), 0.0);
  return {.label = "Number of runs by " + column_words(column.name).words,
          .x_label = column_words(column.name).with_unit(),
          .y_label = "runs",
          .width = page::half_page,
          .height = 200.0,
          .series = {outline},
          .levels = {{.value = column.quantiles.p5, .label = "5 %", .upright = true},
                     {.value = column.quantiles.p95, .label = "95 %", .upright = true}},
          .y_range = page::Range{0.0, 1.1 * std::ranges::max(counts)}};
}

std::string tornado_svg(const Report& report, std::size_t figure, double width) {
  constexpr double row = 20.0;
  constexpr double top = 6.0;
  std::vector<std::pair<std::string, Estimate>> bars;
  double reach = 0.0;
  double left = 60.0;
  for (const QuantityInfluence& of : report.analysis.influences) {
    if (const auto& slope = of.slopes[figure]) {
      bars.emplace_back(page::shortened(column_words(of.name).words, 0.45 * width), *slope);
      reach = std::max({reach, std::abs(slope->low), std::abs(slope->high)});
      left = std::max(left, page::text_width(bars.back().first) + 12.0);
    }
  }
  if (bars.empty()) {
    return {};
  }
  std::ranges::stable_sort(bars, std::ranges::greater{}, [](const auto& bar) { return std::abs(bar.second.value); });
  const page::Range x = page::drawable({-1.05 * reach, 1.05 * reach});
  const double bottom = top + row * static_cast<double>(bars.size());
  page::SvgPlot plot;
  plot.place({left, top, width - 12.0, bottom}, x, {0.0, 1.0});
  plot.begin("chart", "Effect of each quantity on the " + column_words(figure_columns[figure]).words, width,
             bottom + page::tick_row + page::label_row + 7.0);
  plot.outline("frame");
  plot.x_axis(page::even_ticks(x, (width - left) / 90.0), "slope, standard deviations");
  plot.add("<path class=\"grid zero\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", plot.x(0.0), top, bottom);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const auto& [name, slope] = bars[i];
    const double y = top + row * (static_cast<double>(i) + 0.5);
    const auto [from, to] = std::minmax({plot.x(0.0), plot.x(slope.value)});  // by value
    plot.add("<text class=\"axis\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", left - 8.0, y + 4.0,
             page::printed(name));
    plot.add("<rect class=\"bar measured\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"12\"/>", from, y - 6.0,
             std::max(to - from, 1.0));
    plot.add("<path class=\"line measured\" d=\"M{:.1f} {:.1f}v6m0 -3H{:.1f}m0 -3v6\"/>", plot.x(slope.low), y - 3.0,
             plot.x(slope.high));
  }
  return plot.end();
}

page::Chart scatter(const Report& report, std::size_t figure, const std::string& quantity) {
  const Analysis& a = report.analysis;
  const auto place =
      static_cast<std::size_t>(std::ranges::find(report.flown.quantities, quantity) - report.flown.quantities.begin());
  page::Series met{.name = a.question.words(), .role = Role::measured, .mark = Mark::points};
  page::Series not_met{.name = "other runs", .role = Role::limit, .mark = Mark::points};
  const std::size_t step = 1 + report.flown.runs.size() / most_points;
  for (std::size_t i = 0; i < report.flown.runs.size(); ++i) {
    const FlownRun& run = report.flown.runs[i];
    const bool is_met = a.question.is_met_by(run);
    if (run.figures[figure] && (i % step == 0 || std::ranges::find(a.worst, i, &RankedRun::index) != a.worst.end())) {
      page::Series& series = is_met ? met : not_met;
      series.x.push_back(run.numbers[place]);
      series.y.push_back(*run.figures[figure]);
    }
  }
  std::vector<page::Series> series{met, not_met};
  std::erase_if(series, [](const page::Series& one) { return one.x.empty(); });
  return {.label = fmt::format("{} of the runs over {}", column_words(figure_columns[figure]).words,
                               column_words(quantity).words),
          .x_label = column_words(quantity).with_unit(),
          .y_label = column_words(figure_columns[figure]).with_unit(),
          .width = page::half_page,
          .height = 260.0,
          .series = std::move(series)};
}

}  // namespace fantail::campaign
