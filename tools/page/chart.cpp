// SPDX-License-Identifier: MIT
#include "page/chart.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "page/page.hpp"
#include "page/parts.hpp"

namespace fantail::page {
namespace {

constexpr double least_frame_height = 80.0;

Range with_margin(Range range, double share) {
  const double margin = share * (range.high - range.low);
  return {range.low - margin, range.high + margin};
}

Range x_range(const Chart& chart) {
  std::optional<Range> range;
  bool dots = chart.equal_x_ticks_at_points;
  for (const Series& series : chart.series) {
    std::ranges::for_each(series.x, [&](double x) { include(range, x); });
    dots = dots || !has_line(series.mark) || series.mark == Mark::line_and_points;
  }
  for (const Area& area : chart.areas) {
    std::ranges::for_each(area.x, [&](double x) { include(range, x); });
  }
  for (const ShadedRange& stripe : chart.shaded_ranges) {
    include(range, stripe.begin);
    include(range, stripe.end);
  }
  for (const Level& level : chart.levels) {
    if (level.upright) {
      include(range, level.value);
    }
  }
  const Range all = drawable(range.value_or(Range{0.0, 1.0}), chart.x_scale);
  // Half a dot would stand outside.
  return dots && chart.x_scale == Scale::linear ? with_margin(all, 0.03) : all;
}

Range y_range(const Chart& chart, Range x_visible) {
  std::optional<Range> range;
  const auto include_all = [&](const std::vector<double>& x, const std::vector<double>& y) {
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
      if (x[i] >= x_visible.low && x[i] <= x_visible.high) {
        include(range, y[i]);
      }
    }
  };
  for (const Series& series : chart.series) {
    include_all(series.x, series.y);
  }
  for (const Area& area : chart.areas) {
    include_all(area.x, area.low);
    include_all(area.x, area.high);
  }
  for (const Level& level : chart.levels) {
    if (!level.upright) {
      include(range, level.value);
    }
  }
  const bool labelled =
      std::ranges::any_of(chart.levels, [](const Level& l) { return !l.upright && !l.label.empty(); });
  return with_margin(drawable(range.value_or(Range{0.0, 1.0})), labelled ? 0.11 : 0.06);  // room above for the label
}

// The first curve of a role is drawn plainly, further names of the same role with other dashes. What was measured is
// broad where a model is drawn over it, so that both are seen where they agree; a target is broad already.
std::vector<std::string> styles(const Chart& chart) {
  const bool modelled = std::ranges::any_of(chart.series, [](const Series& s) {
    return has_line(s.mark) && (s.role == Role::model || s.role == Role::second_model);
  });
  const bool targeted = std::ranges::any_of(chart.series, [](const Series& s) { return s.role == Role::target; });
  std::vector<std::string> result;
  for (const Series& series : chart.series) {
    std::vector<std::string> names;
    for (const Series& other : chart.series) {
      if (other.role == series.role && std::ranges::find(names, other.name) == names.end()) {
        names.push_back(other.name);
      }
    }
    const auto place = std::ranges::find(names, series.name) - names.begin();
    std::string style = place == 0 ? "" : fmt::format(" dash{}", 1 + (place - 1) % 3);
    if (modelled && !targeted && series.role == Role::measured) {
      style += " beneath";
    }
    result.push_back(std::move(style));
  }
  return result;
}

// The models stand before what was measured, both before what surrounds them, and a landmark before all.
constexpr int deepest = 4;
int depth(const Series& series) {
  if (is_landmark(series.mark)) {
    return deepest;
  }
  switch (series.role) {
    case Role::measured: return 1;
    case Role::model: return 2;
    case Role::second_model: return 3;
    default: return 0;
  }
}

void draw_curves(SvgPlot& plot, LabelPlacer& places, const Chart& chart, const std::vector<std::string>& style) {
  const Box frame = plot.frame();
  // An inner svg: it cuts off what lies outside, where a part is shown, and a reader can zoom it.
  const bool cut = chart.x_range || chart.y_range;
  plot.add(
      "<svg class=\"curves\"{4} x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" viewBox=\"{0:.1f} "
      "{1:.1f} {2:.1f} {3:.1f}\">",
      frame.left, frame.top, frame.width(), frame.height(), cut ? "" : " overflow=\"visible\"");
  draw_shaded_ranges(plot, chart);
  draw_levels(plot, chart);
  for (const Area& area : chart.areas) {
    draw(plot, area, chart.sampled);
  }
  for (int level = 0; level <= deepest; ++level) {
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
      if (depth(chart.series[i]) == level) {
        draw(plot, places, chart.series[i], style[i], chart.sampled);
      }
    }
  }
  plot.add("</svg>");
}

/// What stands in front of "/": "time after lift-off / s".
std::string_view name_of(std::string_view label) { return label.substr(0, label.find(" / ")); }

struct Axes {
  Range x;
  Range y;
  double below;  ///< of the frame
  std::vector<Tick> y_ticks;
  double left;  ///< of the frame
};

Axes axes_of(const Chart& chart) {
  const Range x = chart.x_range ? drawable(*chart.x_range, chart.x_scale) : x_range(chart);
  const Range y = chart.y_range ? drawable(*chart.y_range) : y_range(chart, x);
  const double below = tick_row + (chart.x_label.empty() ? 0.0 : label_row) + 7.0;
  std::vector<Tick> y_ticks = even_ticks(y, std::max((chart.height - below - 30.0) / 36.0, 3.0));
  const double left = std::max(tick_column(y_ticks), chart.least_left);
  return {.x = x, .y = y, .below = below, .y_ticks = std::move(y_ticks), .left = left};
}

}  // namespace

double left_of_frame(const Chart& chart) { return axes_of(chart).left; }

std::string svg(const Chart& chart) {
  const std::vector<std::string> style = styles(chart);
  const Legend legend{chart, style};
  const auto [x, y, below, y_ticks, left] = axes_of(chart);
  const std::vector<Tick> x_ticks =
      chart.equal_x_ticks_at_points && !chart.series.empty() && !chart.series.front().x.empty()
          ? ticks_at(chart.series.front().x, x)
      : chart.x_scale == Scale::logarithmic ? decade_ticks(x, (chart.width - left) / 75.0)
                                            : even_ticks(x, (chart.width - left) / 75.0);
  const double right = std::max(chart.width - end_margin(x_ticks), left + 40.0);

  SvgPlot plot;
  plot.place({left, 0.0, right, 1.0}, x, y, chart.x_scale);
  const TopLabels top_labels{chart, plot};
  const double top =
      6.0 + legend_row * static_cast<double>(legend.rows()) + top_label_row * static_cast<double>(top_labels.rows());
  const double height = std::max(chart.height, top + least_frame_height + below);
  const Box frame{left, top, right, height - below};
  plot.place(frame, x, y, chart.x_scale);

  plot.begin("chart", chart.label, chart.width, height,
             fmt::format(" data-x=\"{:.9g} {:.9g}\" data-y=\"{:.9g} {:.9g}\" data-x-name=\"{}\"{}", x.low, x.high,
                         y.low, y.high, escape_html(chart.x_label.empty() ? "x" : name_of(chart.x_label)),
                         chart.x_scale == Scale::logarithmic ? " data-x-scale=\"logarithmic\"" : ""));
  const bool anything = std::ranges::any_of(chart.series, [](const Series& one) { return anything_in(one); }) ||
                        std::ranges::any_of(chart.areas, [](const Area& one) { return anything_in(one); });
  plot.outline(anything ? "frame" : "frame empty");
  plot.x_axis(anything || chart.x_range || !chart.shaded_ranges.empty() ? x_ticks : std::vector<Tick>{}, chart.x_label);
  plot.y_axis(anything || chart.y_range ? y_ticks : std::vector<Tick>{}, true);
  LabelPlacer places{frame};
  draw_curves(plot, places, chart, style);
  top_labels.draw(plot);
  label_levels(plot, places, chart);
  legend.draw(plot);
  if (!anything) {
    plot.remark("no data");
  }
  return plot.end();
}

std::string standalone(std::string svg) {
  if (const std::size_t begin = svg.find('>'); begin != std::string::npos) {
    svg.insert(begin + 1,
               fmt::format("<style>{}</style><rect class=\"paper\" width=\"100%\" height=\"100%\"/>", chart_css));
  }
  return svg;
}

}  // namespace fantail::page
