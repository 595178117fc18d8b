// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "page/page.hpp"
#include "page/parts.hpp"

namespace fantail::page {
namespace {

constexpr std::size_t most_rows = 4;
constexpr double sample = 28.0;  // the piece of line before a name, with its gap
constexpr double apart = 18.0;   // of two names

bool within(double value, Range range) { return value >= range.low && value <= range.high; }

struct Extent {
  double from;
  double to;
};

std::optional<Extent> visible_extent(const ShadedRange& stripe, const SvgPlot& plot) {
  const double begin = std::max(std::min(stripe.begin, stripe.end), plot.x_range().low);
  const double end = std::min(std::max(stripe.begin, stripe.end), plot.x_range().high);
  if (!(begin <= end)) {
    return std::nullopt;
  }
  return Extent{plot.x(begin), plot.x(end)};
}

}  // namespace

Legend::Legend(const Chart& chart, const std::vector<std::string>& styles) : chart_{chart} {
  std::vector<Entry> entries;
  const auto entry = [&entries](const std::string& name) -> Entry& {
    const auto same = std::ranges::find(entries, name, &Entry::name);
    return same != entries.end() ? *same : entries.emplace_back(Entry{.name = name});
  };
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& one = chart.series[i];
    if (one.name.empty()) {
      continue;
    }
    Entry& of_it = entry(anything_in(one) ? one.name : one.name + " (no data)");
    if (of_it.line.empty()) {
      const std::string_view role = class_of(one.role);
      of_it.line = has_line(one.mark) ? fmt::format("<path class=\"line {}{}\" d=\"M0-4h22\"/>", role, styles[i]) : "";
      if (one.mark == Mark::points || one.mark == Mark::line_and_points) {
        of_it.line += fmt::format("<path class=\"dots {}\" d=\"M11-4h0\"/>", role);
      }
      if (is_landmark(one.mark)) {
        of_it.line += landmark({11.0, -4.0}, one);
      }
    }
  }
  const auto add_swatch = [&](const std::string& name, std::string_view kind, Role role) {
    if (!name.empty()) {
      entry(name).swatch = fmt::format("<path class=\"{} {}\" d=\"M0-9h22v10h-22Z\"/>", kind, class_of(role));
    }
  };
  for (const Area& area : chart.areas) {
    add_swatch(area.name, "area", area.role);
  }
  for (const ShadedRange& stripe : chart.shaded_ranges) {
    if (stripe.role != Role::neutral) {
      add_swatch(stripe.label, "stripe", stripe.role);
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
  for (Entry& one : entries) {
    one.name = shortened(one.name, whole - sample - apart);
    one.width = sample + text_width(one.name) + apart;
    if (one.width > room) {
      rows_.emplace_back();
      room = whole;
    }
    room -= one.width;
    rows_.back().push_back(std::move(one));
  }
}

void Legend::draw(SvgPlot& plot) const {
  if (!chart_.y_label.empty()) {
    plot.add("<text class=\"axis\" x=\"0\" y=\"13\">{}</text>", printed(shortened(chart_.y_label, chart_.width)));
  }
  double y = 13.0;
  for (const std::vector<Entry>& row : rows_) {
    double x = chart_.width + apart;
    for (const Entry& entry : row) {
      x -= entry.width;
    }
    for (const Entry& entry : row) {
      plot.add("<g transform=\"translate({:.1f} {:.1f})\">{}{}<text x=\"{}\">{}</text></g>", x, y, entry.swatch,
               entry.line, sample, printed(entry.name));
      x += entry.width;
    }
    y += legend_row;
  }
}

TopLabels::TopLabels(const Chart& chart, const SvgPlot& plot) {
  constexpr double beside = 4.0;  // a level's label stands right of its line, at the right edge left of it
  const Box frame = plot.frame();
  std::vector<Label> wanted;
  for (const ShadedRange& stripe : chart.shaded_ranges) {
    if (const auto extent = visible_extent(stripe, plot);
        extent && !stripe.label.empty() && stripe.role == Role::neutral) {
      const std::string text = shortened(stripe.label, frame.width());
      const double left = 0.5 * (extent->from + extent->to - text_width(text));
      wanted.push_back({std::max(std::min(left, frame.right - text_width(text)), frame.left), text});
    }
  }
  for (const Level& level : chart.levels) {
    if (level.upright && !level.label.empty() && within(level.value, plot.x_range())) {
      const std::string text = shortened(level.label, frame.width());
      const double right = plot.x(level.value) + beside;
      const double left = plot.x(level.value) - beside - text_width(text);
      wanted.push_back({right + text_width(text) <= chart.width ? right : std::max(left, frame.left), text, &level});
    }
  }
  std::ranges::sort(
      wanted, [](const Label& a, const Label& b) { return a.left != b.left ? a.left < b.left : a.text < b.text; });
  std::array<double, most_rows> taken{};
  taken.fill(-1e9);
  for (Label& label : wanted) {
    const auto row = std::ranges::find_if(taken, [&](double end) { return end <= label.left - beside; });
    if (row != taken.end()) {
      *row = label.left + text_width(label.text) + beside;
      label.row = static_cast<std::size_t>(row - taken.begin());
      rows_ = std::max(rows_, label.row + 1);
      labels_.push_back(label);
    }
  }
  if (std::ranges::any_of(labels_, [](const Label& label) { return label.level != nullptr; })) {
    std::ranges::for_each(labels_, [this](Label& label) { label.row = rows_ - 1 - label.row; });
  }
}

void TopLabels::draw(SvgPlot& plot) const {
  const double top = plot.frame().top;
  for (const Label& label : labels_) {
    const double y = top - 5.0 - top_label_row * static_cast<double>(label.row);
    if (label.level != nullptr) {
      plot.add("<path class=\"level {}\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", class_of(label.level->role),
               plot.x(label.level->value), top, y - 9.0);
    }
    plot.add("<text class=\"mark\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", label.left, y, printed(label.text));
  }
}

void draw_shaded_ranges(SvgPlot& plot, const Chart& chart) {
  for (const ShadedRange& stripe : chart.shaded_ranges) {
    if (const auto extent = visible_extent(stripe, plot)) {
      plot.add(
          "<rect class=\"stripe {}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
          "height=\"{:.1f}\"><title>{}</title></rect>",
          class_of(stripe.role), extent->from, plot.frame().top, std::max(extent->to - extent->from, 1.0),
          plot.frame().height(), printed(stripe.label));
    }
  }
}

void draw_levels(SvgPlot& plot, const Chart& chart) {
  const Box frame = plot.frame();
  for (const Level& level : chart.levels) {
    if (!within(level.value, level.upright ? plot.x_range() : plot.y_range())) {
      continue;
    }
    plot.add("<path class=\"level {}\" d=\"", class_of(level.role));
    if (level.upright) {
      plot.add("M{:.1f} {:.1f}V{:.1f}", plot.x(level.value), frame.top, frame.bottom);
    } else {
      plot.add("M{:.1f} {:.1f}H{:.1f}", frame.left, plot.y(level.value), frame.right);
    }
    plot.add("\"><title>{}</title></path>", printed(level.label));
  }
}

void label_levels(SvgPlot& plot, LabelPlacer& places, const Chart& chart) {
  const Box frame = plot.frame();
  for (const Level& level : chart.levels) {
    if (!level.upright && within(level.value, plot.y_range())) {
      const int points = static_cast<int>(frame.width() / 3.0);
      for (int i = 0; i <= points; ++i) {
        places.avoid({frame.left + 3.0 * i, plot.y(level.value)});
      }
    }
  }
  for (const Level& level : chart.levels) {
    if (level.upright || level.label.empty() || !within(level.value, plot.y_range())) {
      continue;
    }
    constexpr double letters = 15.0;
    const std::string text = shortened(level.label, frame.width() - 12.0);
    const double width = text_width(text);
    const double y = plot.y(level.value);
    std::vector<Box> candidates;
    for (const double share : {1.0, 0.0, 0.5, 0.25, 0.75}) {
      const double left = frame.left + 5.0 + share * (frame.width() - 10.0 - width);
      for (const double top : {y - letters - 1.0, y + 1.0}) {
        candidates.push_back({left, top, left + width, top + letters});
      }
    }
    if (const auto place = places.take(candidates)) {
      plot.add("<text class=\"mark {}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", class_of(level.role), place->left,
               place->bottom - 3.5, printed(text));
    }
  }
}

}  // namespace fantail::page
