// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "page/page.hpp"
#include "page/parts.hpp"
#include "page/svg_plot.hpp"

namespace fantail::page {
namespace {

using Columns = std::span<const std::vector<double>>;

struct IndexRange {
  std::size_t begin;
  std::size_t end;
};

bool any_pair(const std::vector<double>& x, const std::vector<double>& y) {
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (std::isfinite(x[i]) && std::isfinite(y[i])) {
      return true;
    }
  }
  return false;
}

IndexRange within(const std::vector<double>& x, std::size_t count, Range range) {
  const auto end = x.begin() + static_cast<std::ptrdiff_t>(count);
  if (!std::is_sorted(x.begin(), end)) {
    return {0, count};
  }
  const auto first = static_cast<std::size_t>(std::lower_bound(x.begin(), end, range.low) - x.begin());
  const auto last = static_cast<std::size_t>(std::upper_bound(x.begin(), end, range.high) - x.begin());
  return {first > 0 ? first - 1 : 0, std::min(last + 1, count)};
}

std::vector<std::size_t> thinned(Columns columns, IndexRange part, std::size_t buckets) {
  std::vector<std::vector<double>> parts;
  for (const std::vector<double>& column : columns) {
    parts.emplace_back(column.begin() + static_cast<std::ptrdiff_t>(part.begin),
                       column.begin() + static_cast<std::ptrdiff_t>(part.end));
  }
  std::vector<std::size_t> kept = keep_extremes(parts, buckets);
  for (std::size_t& i : kept) {
    i += part.begin;
  }
  return kept;
}

// Which samples to draw of columns over x: gapless_parts without a gap.
std::vector<std::vector<std::size_t>> gapless_parts(const std::vector<double>& x, Columns columns, const SvgPlot& plot,
                                                    bool sampled) {
  std::size_t count = x.size();
  for (const std::vector<double>& column : columns) {
    count = std::min(count, column.size());
  }
  const auto drawable_at = [&](std::size_t i) {
    return std::isfinite(x[i]) && std::ranges::all_of(columns, [i](const auto& c) { return std::isfinite(c[i]); });
  };
  std::vector<bool> after_gap(count);
  for (const std::size_t i : sampled ? gaps({x.data(), count}) : std::vector<std::size_t>{}) {
    after_gap[i] = true;
  }
  const IndexRange visible = within(x, count, plot.x_range());
  const double buckets = std::max(plot.frame().width() / 2.0, 10.0);
  std::vector<std::vector<std::size_t>> result;
  for (std::size_t begin = visible.begin; begin < visible.end;) {
    std::size_t end = begin;
    while (end < visible.end && drawable_at(end) && (end == begin || !after_gap[end])) {
      ++end;
    }
    if (end == begin) {
      ++begin;
      continue;
    }
    const double share = static_cast<double>(end - begin) / static_cast<double>(visible.end - visible.begin);
    result.push_back(thinned(columns, {begin, end}, static_cast<std::size_t>(std::ceil(share * buckets))));
    begin = end;
  }
  return result;
}

// Labels know a curve by points on it, close enough together that none slips between two.
void avoid_line(LabelPlacer& places, Pixel from, Pixel to) {
  constexpr double apart = 5.0;
  const int parts = static_cast<int>(std::min(std::ceil(std::hypot(to.x - from.x, to.y - from.y) / apart), 500.0));
  for (int i = 0; i <= parts; ++i) {
    const double part = static_cast<double>(i) / std::max(parts, 1);
    places.avoid({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)});
  }
}

// A point between two others at the same height is left out: most of a command is such points. Not where a way turns
// back on itself.
std::string path_of(const std::vector<Pixel>& line, bool step) {
  std::string path;
  std::string waiting;
  std::string height;
  double last_x = 0.0;
  double way = 0.0;  // of the level stretch so far
  for (const Pixel p : line) {
    std::string here = fmt::format("{:.1f}", p.y);
    if (path.empty()) {
      path = fmt::format("M{:.1f} {}", p.x, here);
    } else if (here == height) {
      const double step_x = p.x - last_x;
      if (way * step_x < 0.0) {
        path += waiting;
      }
      way = step_x == 0.0 ? way : step_x;
      waiting = fmt::format("H{:.1f}", p.x);
    } else {
      path += waiting + (step ? fmt::format("H{:.1f}V{}", p.x, here) : fmt::format("L{:.1f} {}", p.x, here));
      waiting.clear();
      way = 0.0;
    }
    height = std::move(here);
    last_x = p.x;
  }
  return path + waiting;
}

void draw_line(SvgPlot& plot, LabelPlacer& places, const Series& series, std::string_view style, bool sampled) {
  std::string path;
  std::string lone;  // a sample between two gaps would have no length
  for (const std::vector<std::size_t>& part : gapless_parts(series.x, std::span{&series.y, 1}, plot, sampled)) {
    std::vector<Pixel> line;
    for (const std::size_t i : part) {
      line.push_back({plot.x(series.x[i]), plot.y(series.y[i])});
      avoid_line(places, line.size() > 1 ? line[line.size() - 2] : line.back(), line.back());
    }
    if (line.size() == 1) {
      lone += fmt::format("M{:.1f} {:.1f}h0", line.front().x, line.front().y);
    } else {
      path += path_of(line, series.mark == Mark::step);
    }
  }
  if (!path.empty()) {
    plot.add("<path class=\"line {}{}\" data-name=\"{}\" d=\"{}\"/>", class_of(series.role), style,
             escape_html(series.name), path);
  }
  if (!lone.empty()) {
    plot.add("<path class=\"dots lone {}\" d=\"{}\"/>", class_of(series.role), lone);
  }
}

// Dots that would hide each other wholly are drawn once; dots outside the axes would stand in the texts.
std::vector<Pixel> dots_to_draw(const SvgPlot& plot, const Series& series, double per_unit) {
  const Box frame = plot.frame();
  std::set<std::pair<long, long>> drawn;
  std::vector<Pixel> kept;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
      continue;
    }
    const Pixel p{plot.x(series.x[i]), plot.y(series.y[i])};
    const bool seen =
        p.x >= frame.left - 0.1 && p.x <= frame.right + 0.1 && p.y >= frame.top - 0.1 && p.y <= frame.bottom + 0.1;
    if (seen && drawn.emplace(std::lround(per_unit * p.x), std::lround(per_unit * p.y)).second) {
      kept.push_back(p);
    }
  }
  return kept;
}

void draw_landmarks(SvgPlot& plot, LabelPlacer& places, const Series& series) {
  for (const Pixel& p : dots_to_draw(plot, series, 2.0)) {
    plot.add("{}", landmark(p, series));
    places.avoid(p);
  }
}

void draw_dots(SvgPlot& plot, LabelPlacer& places, const Series& series) {
  constexpr std::size_t most = 30'000;  // more only make the page large: they cover each other in part
  double per_unit = 2.0;
  std::vector<Pixel> dots = dots_to_draw(plot, series, per_unit);
  while (dots.size() > most) {
    dots = dots_to_draw(plot, series, per_unit *= 0.5);
  }
  std::string path;
  for (const Pixel& p : dots) {
    path += fmt::format("M{:.1f} {:.1f}h0", p.x, p.y);
    places.avoid(p);
  }
  if (!path.empty()) {
    plot.add("<path class=\"dots{} {}\" data-name=\"{}\" d=\"{}\"/>", dots.size() > 120 ? " many" : "",
             class_of(series.role), escape_html(series.name), path);
  }
}

}  // namespace

std::string_view class_of(Role role) {
  switch (role) {
    case Role::measured: return "measured";
    case Role::model: return "model";
    case Role::second_model: return "second";
    case Role::target: return "target";
    case Role::reference: return "reference";
    case Role::limit: return "limit";
    case Role::waiting: return "waiting";
    case Role::neutral: break;
  }
  return "neutral";
}

bool anything_in(const Series& series) { return any_pair(series.x, series.y); }
bool anything_in(const Area& area) { return any_pair(area.x, area.low) && any_pair(area.x, area.high); }

void draw(SvgPlot& plot, LabelPlacer& places, const Series& series, std::string_view style, bool sampled) {
  if (has_line(series.mark)) {
    draw_line(plot, places, series, style, sampled);
  }
  if (series.mark == Mark::points || series.mark == Mark::line_and_points) {
    draw_dots(plot, places, series);
  }
  if (is_landmark(series.mark)) {
    draw_landmarks(plot, places, series);
  }
}

// Twice: a wide one in the colour of the paper, so that it stands out from the dots behind it. The path of the name is
// a dot without a width, which the cursor reads.
std::string landmark(Pixel at, const Series& series) {
  const std::string shape = series.mark == Mark::ring
                                ? fmt::format("M{:.1f} {:.1f}a6 6 0 1 0 12 0a6 6 0 1 0-12 0", at.x - 6.0, at.y)
                                : fmt::format("M{0:.1f} {1:.1f}l12 12m0-12l-12 12", at.x - 6.0, at.y - 6.0);
  return fmt::format(
      "<path class=\"landmark halo\" d=\"{0}\"/><path class=\"landmark {1}\" d=\"{0}\"/>"
      "<path class=\"dots place {1}\" data-name=\"{2}\" d=\"M{3:.1f} {4:.1f}h0\"/>",
      shape, class_of(series.role), escape_html(series.name), at.x, at.y);
}

void draw(SvgPlot& plot, const Area& area, bool sampled) {
  const std::vector<std::vector<double>> edges{area.low, area.high};
  std::string path;
  for (const std::vector<std::size_t>& part : gapless_parts(area.x, edges, plot, sampled)) {
    const double least = part.size() == 1 ? 1.5 : 0.0;  // one sample alone is still seen
    for (const std::size_t i : part) {
      path += fmt::format("{}{:.1f} {:.1f}", i == part.front() ? 'M' : 'L', plot.x(area.x[i]) - least,
                          plot.y(area.high[i]));
    }
    for (std::size_t i = part.size(); i-- > 0;) {
      path += fmt::format("L{:.1f} {:.1f}", plot.x(area.x[part[i]]) + least, plot.y(area.low[part[i]]));
    }
    path += 'Z';
  }
  if (!path.empty()) {
    plot.add("<path class=\"area {}\" data-name=\"{}\" d=\"{}\"/>", class_of(area.role), escape_html(area.name), path);
  }
}

}  // namespace fantail::page
