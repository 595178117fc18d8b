// SPDX-License-Identifier: MIT
#include "detection/bounds_chart.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "detection/shown_event.hpp"
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
  for (double power = range.low; power <= range.high + 0.5; power += 1.0) {
    ticks.push_back({power, fmt::format("{:.{}f}", std::pow(10.0, power), power < 0.0 ? static_cast<int>(-power) : 0)});
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
    plot.add("<g><title>{}: {} of {}</title><path class=\"line {}\" d=\"M{:.1f} {:.1f}H{:.1f}m0 -3v6\"/>",
             page::printed(report.campaign.rules[rule].name()), with_bound(count.controlling, count.events),
             count.events, role, plot.frame().left, y, plot.x(std::log10(percent_bound(count))));
    if (count.controlling > 0) {
      plot.add("<path class=\"dots {}\" d=\"M{:.1f} {:.1f}h0\"/>", role,
               plot.x(std::log10(100.0 * static_cast<double>(count.controlling) / static_cast<double>(count.events))),
               y);
    }
    plot.add("</g>");
  }
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
  plot.x_axis(ticks, "moves a canard / %: counted (dot), at most (bar)");
  draw_legend(plot, report, width);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    draw_row(plot, report, rows[i], top + row * static_cast<double>(i) + 0.5 * gap);
  }
  return plot.end();
}

}  // namespace fantail::detection
