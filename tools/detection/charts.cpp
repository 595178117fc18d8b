// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "detection/report.hpp"
#include "page/page.hpp"
#include "page/parts.hpp"
#include "page/svg_plot.hpp"

namespace fantail::detection {
namespace {

constexpr double bar_row = 11.0;
constexpr double gap = 10.0;  // between kinds
constexpr double legend_row = 17.0;

const Count& well(const Report& report, Kind kind, std::size_t rule) {
  return report.results.of_kind[index(kind)]->of_rule[rule][0];
}

double percent_bound(const Count& count) { return 100.0 * upper_bound_95(count.controlling, count.events); }

/// The kinds that have a row, in their order.
std::vector<Kind> rows_of(const Report& report) {
  std::vector<Kind> rows;
  std::ranges::copy_if(report.campaign.kinds, std::back_inserter(rows),
                       [&](Kind kind) { return !is_launch(kind) && well(report, kind, 0).events > 0; });
  return rows;
}

/// Powers of ten, by their logarithms.
std::vector<page::Tick> decades(const page::Range& range) {
  std::vector<page::Tick> ticks;
  for (long power = std::lround(range.low); power <= std::lround(range.high); ++power) {
    const auto logarithm = static_cast<double>(power);
    ticks.push_back({logarithm, fmt::format("{:.{}f}", std::pow(10.0, logarithm), std::max(0L, -power))});
  }
  return ticks;
}

void draw_legend(page::SvgPlot& plot, const Report& report, double width) {
  for (std::size_t rule = 0; rule < report.campaign.rules.size(); ++rule) {
    const double y = legend_row * static_cast<double>(rule);
    plot.add("<path class=\"line {}\" d=\"M2 {:.1f}h16\"/><text x=\"24\" y=\"{:.1f}\">{}</text>",
             page::class_of(roles[rule % roles.size()]), y + 9.0, y + 13.0,
             page::printed(page::shortened(report.campaign.rules[rule].name(), width - 30.0)));
  }
}

void draw_row(page::SvgPlot& plot, const Report& report, Kind kind, double top) {
  const std::size_t rules = report.campaign.rules.size();
  const double middle = top + 0.5 * bar_row * static_cast<double>(rules);
  plot.add("<text class=\"axis\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", plot.frame().left - 8.0,
           middle + 4.0, info(kind).name);
  for (std::size_t rule = 0; rule < rules; ++rule) {
    const Count& count = well(report, kind, rule);
    const double y = top + bar_row * (static_cast<double>(rule) + 0.5);
    const std::string_view role = page::class_of(roles[rule % roles.size()]);
    const double bound = plot.x(std::log10(percent_bound(count)));
    plot.add("<g><title>{}: {} of {}</title>", page::printed(report.campaign.rules[rule].name()),
             with_bound(count.controlling, count.events), count.events);
    if (count.controlling > 0) {
      const double counted =
          plot.x(std::log10(100.0 * static_cast<double>(count.controlling) / static_cast<double>(count.events)));
      plot.add(
          "<path class=\"line {0}\" d=\"M{1:.1f} {2:.1f}H{3:.1f}m0 -3v6\"/><path class=\"dots {0}\" d=\"M{1:.1f} "
          "{2:.1f}h0\"/>",
          role, counted, y, bound);
    } else {  // somewhere below the bound: an arrow that is not filled
      plot.add("<path class=\"bound {}\" d=\"M{:.1f} {:.1f}l-9 -4v8z m-9 0h-14\"/>", role, bound, y);
    }
    plot.add("</g>");
  }
}

page::Series shares(const Histogram& histogram, double scale, std::string name, page::Role role) {
  page::Series series{.name = std::move(name), .role = role, .mark = page::Mark::step};
  std::uint64_t sum = 0;
  const auto total = static_cast<double>(histogram.total());
  for (const auto& [value, times] : histogram.counts()) {
    sum += times;
    series.x.push_back(scale * value);
    series.y.push_back(100.0 * static_cast<double>(sum) / total);
  }
  return series;
}

page::Chart by_thrust_chart(const Report& report, Kind kind) {
  page::Chart chart{.label = "Share of the launches that are missed or late, by their thrust",
                    .x_label = "peak thrust over weight / g",
                    .y_label = "missed or late / %"};
  for (std::size_t rule = 0; rule < report.campaign.rules.size(); ++rule) {
    const Count& count = report.results.of_kind[index(kind)]->of_rule[rule][0];
    page::Series series{.name = report.campaign.rules[rule].name(),
                        .role = roles[rule % roles.size()],
                        .mark = page::Mark::line_and_points};
    for (const auto& [peak_g, all] : count.all_by_peak_g.counts()) {
      const std::uint64_t bad = count.missed_by_peak_g.times(peak_g) + count.late_by_peak_g.times(peak_g);
      series.x.push_back(peak_g + 0.5);
      series.y.push_back(100.0 * static_cast<double>(bad) / static_cast<double>(all));
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

/// Four times the least median: what lies far beyond is rare, and would leave no room for the rest.
std::optional<page::Range> most_of(const std::vector<double>& medians) {
  const double least = medians.empty() ? 0.0 : std::ranges::min(medians);
  return least > 0.0 ? std::optional<page::Range>{{0.0, 4.0 * least}} : std::nullopt;
}

}  // namespace

std::string bounds_svg(const Report& report, double width) {
  const std::vector<Kind> rows = rows_of(report);
  const std::size_t rules = report.campaign.rules.size();
  if (rows.empty()) {
    return {};
  }
  double least = 100.0;
  double most = 0.0;
  for (const Kind kind : rows) {
    for (std::size_t rule = 0; rule < rules; ++rule) {
      const double bound = percent_bound(well(report, kind, rule));
      least = std::min(least, bound);
      most = std::max(most, bound);
    }
  }
  // At least a decade of bar.
  const page::Range x{std::floor(std::log10(least)) - 1.0, std::ceil(std::log10(most))};
  const std::vector<page::Tick> ticks = decades(x);
  const double row = bar_row * static_cast<double>(rules) + gap;
  const double top = legend_row * static_cast<double>(rules) + 6.0;
  const double bottom = top + row * static_cast<double>(rows.size());
  page::SvgPlot plot;
  double left = 84.0;
  for (const Kind kind : rows) {
    left = std::max(left, page::text_width(info(kind).name) + 12.0);
  }
  plot.place({left, top, width - page::end_margin(ticks), bottom}, x, {0.0, 1.0});
  plot.begin("chart", "False actuations of each kind of event, with their 95 % bounds", width,
             bottom + page::tick_row + page::label_row + 7.0);
  plot.outline("frame");
  for (const page::Tick& tick : ticks) {
    plot.add("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", plot.x(tick.value), top, bottom);
  }
  plot.x_axis(ticks, "events that move a canard / %");
  draw_legend(plot, report, width);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    draw_row(plot, report, rows[i], top + row * static_cast<double>(i) + 0.5 * gap);
  }
  return plot.end();
}

std::vector<result::Block> distributions(const Report& report, Kind kind) {
  page::Chart latency{.label = "Share of the launches detected within a time",
                      .x_label = "time after the thrust crosses the threshold / s",
                      .y_label = "detected / %",
                      .width = page::half_page};
  page::Chart way{.label = "Share of the launches in which control has started within a distance",
                  .x_label = "true distance along the guide / m",
                  .y_label = "in control / %",
                  .width = page::half_page};
  std::vector<double> latencies;
  std::vector<double> ways;
  for (std::size_t rule = 0; rule < report.campaign.rules.size(); ++rule) {
    const Count& count = report.results.of_kind[index(kind)]->of_rule[rule][0];
    if (count.controlling > 0) {
      const std::string name = report.campaign.rules[rule].name();
      latencies.push_back(1e-3 * count.latency_ms.point(0.5).value_or(0));
      ways.push_back(1e-2 * count.distance_cm.point(0.5).value_or(0));
      latency.series.push_back(shares(count.latency_ms, 1e-3, name, roles[rule % roles.size()]));
      way.series.push_back(shares(count.distance_cm, 1e-2, name, roles[rule % roles.size()]));
    }
  }
  if (latency.series.empty()) {
    return {};
  }
  latency.x_range = most_of(latencies);
  way.x_range = most_of(ways);
  return {result::Picture{latency}, result::Picture{way}, result::Picture{by_thrust_chart(report, kind)}};
}

}  // namespace fantail::detection
