// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "page/parts.hpp"
#include "page/thinning.hpp"

namespace fantail::page {
namespace {

using Columns = std::span<const std::vector<double>>;

struct Stretch {
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

Stretch within(const std::vector<double>& x, std::size_t count, Range range) {
  const auto end = x.begin() + static_cast<std::ptrdiff_t>(count);
  if (!std::is_sorted(x.begin(), end)) {
    return {0, count};
  }
  const auto first = static_cast<std::size_t>(std::lower_bound(x.begin(), end, range.low) - x.begin());
  const auto last = static_cast<std::size_t>(std::upper_bound(x.begin(), end, range.high) - x.begin());
  return {first > 0 ? first - 1 : 0, std::min(last + 1, count)};
}

std::vector<std::size_t> thinned(Columns columns, Stretch stretch, std::size_t buckets) {
  std::vector<std::vector<double>> parts;
  for (const std::vector<double>& column : columns) {
    parts.emplace_back(column.begin() + static_cast<std::ptrdiff_t>(stretch.begin),
                       column.begin() + static_cast<std::ptrdiff_t>(stretch.end));
  }
  std::vector<std::size_t> kept = keep_extremes(parts, buckets);
  for (std::size_t& i : kept) {
    i += stretch.begin;
  }
  return kept;
}

// Which samples to draw of columns over x: stretches without a gap.
std::vector<std::vector<std::size_t>> stretches(const std::vector<double>& x, Columns columns, const Drawing& drawing,
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
  const Stretch shown = within(x, count, drawing.x_range());
  const double buckets = std::max(drawing.frame().width() / 2.0, 10.0);
  std::vector<std::vector<std::size_t>> result;
  for (std::size_t begin = shown.begin; begin < shown.end;) {
    std::size_t end = begin;
    while (end < shown.end && drawable_at(end) && (end == begin || !after_gap[end])) {
      ++end;
    }
    if (end == begin) {
      ++begin;
      continue;
    }
    const double share = static_cast<double>(end - begin) / static_cast<double>(shown.end - shown.begin);
    result.push_back(thinned(columns, {begin, end}, static_cast<std::size_t>(std::ceil(share * buckets))));
    begin = end;
  }
  return result;
}

// Labels know a curve by points on it, close enough together that none slips between two.
void tell(LabelPlaces& places, Pixel from, Pixel to) {
  constexpr double apart = 5.0;
  const int parts = static_cast<int>(std::min(std::ceil(std::hypot(to.x - from.x, to.y - from.y) / apart), 500.0));
  for (int i = 0; i <= parts; ++i) {
    const double part = static_cast<double>(i) / std::max(parts, 1);
    places.avoid({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)});
  }
}

// A point between two others at the same height is left out: most of a command is such points.
std::string path_of(const std::vector<Pixel>& line, bool step) {
  std::string path;
  std::string waiting;
  std::string height;
  for (const Pixel p : line) {
    std::string here = fmt::format("{:.1f}", p.y);
    if (path.empty()) {
      path = fmt::format("M{:.1f} {}", p.x, here);
    } else if (here == height) {
      waiting = fmt::format("H{:.1f}", p.x);
    } else {
      path += waiting + (step ? fmt::format("H{:.1f}V{}", p.x, here) : fmt::format("L{:.1f} {}", p.x, here));
      waiting.clear();
    }
    height = std::move(here);
  }
  return path + waiting;
}

void draw_line(Drawing& drawing, LabelPlaces& places, const Series& series, std::string_view style, bool sampled) {
  std::string path;
  std::string lone;  // a sample between two gaps would have no length
  for (const std::vector<std::size_t>& stretch : stretches(series.x, std::span{&series.y, 1}, drawing, sampled)) {
    std::vector<Pixel> line;
    for (const std::size_t i : stretch) {
      line.push_back({drawing.x(series.x[i]), drawing.y(series.y[i])});
      tell(places, line.size() > 1 ? line[line.size() - 2] : line.back(), line.back());
    }
    if (line.size() == 1) {
      lone += fmt::format("M{:.1f} {:.1f}h0", line.front().x, line.front().y);
    } else {
      path += path_of(line, series.mark == Mark::step);
    }
  }
  if (!path.empty()) {
    drawing.add("<path class=\"line {}{}\" d=\"{}\"/>", class_of(series.role), style, path);
  }
  if (!lone.empty()) {
    drawing.add("<path class=\"dots lone {}\" d=\"{}\"/>", class_of(series.role), lone);
  }
}

// Dots that would hide each other wholly are drawn once; dots outside the axes would stand in the texts.
void draw_dots(Drawing& drawing, LabelPlaces& places, const Series& series) {
  const Box frame = drawing.frame();
  std::set<std::pair<long, long>> drawn;
  std::string path;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
      continue;
    }
    const Pixel p{drawing.x(series.x[i]), drawing.y(series.y[i])};
    const bool seen =
        p.x >= frame.left - 0.1 && p.x <= frame.right + 0.1 && p.y >= frame.top - 0.1 && p.y <= frame.bottom + 0.1;
    if (seen && drawn.emplace(std::lround(2.0 * p.x), std::lround(2.0 * p.y)).second) {
      path += fmt::format("M{:.1f} {:.1f}h0", p.x, p.y);
      places.avoid(p);
    }
  }
  if (!path.empty()) {
    drawing.add("<path class=\"dots{} {}\" d=\"{}\"/>", drawn.size() > 120 ? " many" : "", class_of(series.role), path);
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
    case Role::neutral: break;
  }
  return "neutral";
}

bool anything_in(const Series& series) { return any_pair(series.x, series.y); }
bool anything_in(const Area& area) { return any_pair(area.x, area.low) && any_pair(area.x, area.high); }

void draw(Drawing& drawing, LabelPlaces& places, const Series& series, std::string_view style, bool sampled) {
  if (series.mark != Mark::points) {
    draw_line(drawing, places, series, style, sampled);
  }
  if (series.mark == Mark::points || series.mark == Mark::line_and_points) {
    draw_dots(drawing, places, series);
  }
}

void draw(Drawing& drawing, const Area& area, bool sampled) {
  const std::vector<std::vector<double>> edges{area.low, area.high};
  std::string path;
  for (const std::vector<std::size_t>& stretch : stretches(area.x, edges, drawing, sampled)) {
    const double least = stretch.size() == 1 ? 1.5 : 0.0;  // one sample alone is still seen
    for (const std::size_t i : stretch) {
      path += fmt::format("{}{:.1f} {:.1f}", i == stretch.front() ? 'M' : 'L', drawing.x(area.x[i]) - least,
                          drawing.y(area.high[i]));
    }
    for (std::size_t i = stretch.size(); i-- > 0;) {
      path += fmt::format("L{:.1f} {:.1f}", drawing.x(area.x[stretch[i]]) + least, drawing.y(area.low[stretch[i]]));
    }
    path += 'Z';
  }
  if (!path.empty()) {
    drawing.add("<path class=\"area {}\" d=\"{}\"/>", class_of(area.role), path);
  }
}

}  // namespace fantail::page
