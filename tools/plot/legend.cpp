// SPDX-License-Identifier: MIT
#include "plot/legend.hpp"

#include <algorithm>
#include <cmath>

#include "plot/curves.hpp"
#include "plot/lettering.hpp"

namespace fantail::plot {
namespace {

constexpr double sample = 28.0;  // the piece of line before a name, with its gap
constexpr double apart = 18.0;

bool nothing_in(const Series& series) {
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (std::isfinite(series.x[i]) && std::isfinite(series.y[i])) {
      return false;
    }
  }
  return true;
}

}  // namespace

Legend::Legend(const Chart& chart, const std::vector<std::string>& styles) : chart_{chart} {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    if (!series.name.empty() && std::ranges::find(entries, series.name, &Entry::name) == entries.end()) {
      entries.push_back({series.name, nullptr, &series, styles[i]});
    }
  }
  for (const Area& area : chart.areas) {
    const auto same = std::ranges::find(entries, area.name, &Entry::name);
    if (same != entries.end()) {
      same->area = &area;
    } else if (!area.name.empty()) {
      entries.push_back({area.name, &area});
    }
  }
  if (entries.size() < 2) {
    entries.clear();
  }
  if (!chart.y_label.empty() || !entries.empty()) {
    rows_.emplace_back();
  }
  const double whole = chart.width;
  double room = whole - (chart.y_label.empty() ? 0.0 : text_width(chart.y_label) + 2.0 * apart);
  for (Entry& entry : entries) {
    const std::string text = entry.name + (entry.series != nullptr && nothing_in(*entry.series) ? " (no data)" : "");
    entry.name = shortened(text, whole - sample - apart);
    entry.width = sample + text_width(entry.name) + apart;
    if (entry.width > room) {
      rows_.emplace_back();
      room = whole;
    }
    room -= entry.width;
    rows_.back().push_back(std::move(entry));
  }
}

void Legend::draw(Drawing& drawing) const {
  if (!chart_.y_label.empty()) {
    drawing.add("<text class=\"axis\" x=\"0\" y=\"13\">{}</text>", printed(shortened(chart_.y_label, chart_.width)));
  }
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const double y = 13.0 + legend_row * static_cast<double>(row);
    double x = chart_.width + apart;
    for (const Entry& entry : rows_[row]) {
      x -= entry.width;
    }
    for (const Entry& entry : rows_[row]) {
      if (entry.area != nullptr) {
        drawing.add("<path class=\"area {}\" d=\"M{:.1f} {:.1f}h22v10h-22Z\"/>", class_of(entry.area->role), x,
                    y - 9.0);
      }
      if (entry.series != nullptr && entry.series->mark != Mark::points) {
        drawing.add("<path class=\"line {}{}\" d=\"M{:.1f} {:.1f}h22\"/>", class_of(entry.series->role), entry.style, x,
                    y - 4.0);
      }
      if (entry.series != nullptr &&
          (entry.series->mark == Mark::points || entry.series->mark == Mark::line_and_points)) {
        drawing.add("<path class=\"dots {}\" d=\"M{:.1f} {:.1f}h0\"/>", class_of(entry.series->role), x + 11.0,
                    y - 4.0);
      }
      drawing.add("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", x + sample, y, printed(entry.name));
      x += entry.width;
    }
  }
}

}  // namespace fantail::plot
