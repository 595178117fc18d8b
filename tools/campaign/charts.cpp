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
#include "text/layout.hpp"

namespace fantail::campaign {
namespace {

using page::Mark;
using page::Role;

constexpr std::size_t most_points = 2'000;  // of a scatter: the page stays small, and more are one cloud

/// Bins as Freedman and Diaconis choose them, with the middle half that a normal law of these ends has, within what can
/// be seen.
std::size_t bins_of(const Column& column, const page::Range& range) {
  constexpr double fewest = 8.0;
  constexpr double most = 60.0;
  const double middle_half = 0.41 * (column.quantiles.p95 - column.quantiles.p5);
  const double width = 2.0 * middle_half / std::cbrt(static_cast<double>(column.values.size()));
  const double bins = width > 0.0 ? (range.high - range.low) / width : most;
  return static_cast<std::size_t>(std::clamp(bins, fewest, most));
}

/// Of all values, or where some lie far out: it ends at twice the width of the middle nine tenths beyond these.
page::Range robust_range(const Column& column) {
  const double reach = 2.0 * (column.quantiles.p95 - column.quantiles.p5);
  return reach > 0.0 ? page::Range{std::max(column.least, column.quantiles.p5 - reach),
                                   std::min(column.largest, column.quantiles.p95 + reach)}
                     : page::Range{column.least, column.largest};
}

bool is_within(const page::Range& range, double value) { return value >= range.low && value <= range.high; }

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
  const page::Range range = robust_range(column);
  const std::size_t bins = bins_of(column, range);
  const double width = (range.high - range.low) / static_cast<double>(bins);
  std::vector<double> counts(bins, 0.0);
  for (const double value : column.values) {
    if (is_within(range, value)) {
      counts[std::min(bins - 1, static_cast<std::size_t>((value - range.low) / width))] += 1.0;
    }
  }
  page::Series outline{.name = "runs", .role = Role::measured, .mark = Mark::step};
  for (std::size_t i = 0; i <= bins; ++i) {
    outline.x.push_back(range.low + width * static_cast<double>(i));
    outline.y.push_back(i < bins ? counts[i] : 0.0);
  }
  outline.x.insert(outline.x.begin(), range.low);
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

std::string runs_beyond_histogram(const Column& column) {
  const page::Range range = robust_range(column);
  const auto beyond = static_cast<std::size_t>(
      std::ranges::count_if(column.values, [&](double value) { return !is_within(range, value); }));
  const std::string unit = column_words(column.name).unit;
  return beyond == 0 ? ""
                     : fmt::format("{} of {} outside this range; all lie between {} and {}{}{}.", beyond,
                                   text::counted(column.values.size(), "run"), five_digits(column.least),
                                   five_digits(column.largest), unit.empty() ? "" : " ", unit);
}

std::string tornado_svg(const Report& report, std::size_t figure, double width) {
  constexpr double top = 6.0;
  const bool is_narrow = width <= page::half_page;
  const double row = is_narrow ? 36.0 : 20.0;
  const double room = is_narrow ? width - 16.0 : 0.45 * width;
  std::vector<std::pair<std::string, Estimate>> bars;
  double reach = 0.0;
  double left = is_narrow ? 12.0 : 60.0;
  for (const QuantityInfluence& of : report.analysis.influences) {
    if (const auto& slope = of.slopes[figure]) {
      bars.emplace_back(page::shortened(column_words(of.name).words, room), *slope);
      reach = std::max({reach, std::abs(slope->low), std::abs(slope->high)});
      left = is_narrow ? left : std::max(left, page::text_width(bars.back().first) + 12.0);
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
  std::vector<page::Tick> ticks;
  for (double wanted = (width - left) / 90.0; ticks.size() < 3 && wanted < 12.0; wanted += 1.0) {
    ticks = page::even_ticks(x, wanted);  // zero alone says nothing
  }
  plot.x_axis(ticks, "slope, standard deviations");
  plot.add("<path class=\"grid zero\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", plot.x(0.0), top, bottom);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const auto& [name, slope] = bars[i];
    const double y = top + row * (static_cast<double>(i) + 1.0) - 10.0;       // of the middle of the bar
    const auto [from, to] = std::minmax({plot.x(0.0), plot.x(slope.value)});  // by value
    plot.add("<text class=\"axis\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>",
             is_narrow ? left + 4.0 : left - 8.0, is_narrow ? y - 11.0 : y + 4.0, is_narrow ? "start" : "end",
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
