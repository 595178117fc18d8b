// SPDX-License-Identifier: MIT
#include "plot/marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "plot/curves.hpp"
#include "plot/lettering.hpp"

namespace fantail::plot {
namespace {

constexpr std::size_t most_rows = 3;

bool within(double value, Range range) { return value >= range.low && value <= range.high; }

struct Extent {
  double from;
  double to;
};

std::optional<Extent> shown(const Stripe& stripe, const Drawing& drawing) {
  const double begin = std::max(std::min(stripe.begin, stripe.end), drawing.x_range().low);
  const double end = std::min(std::max(stripe.begin, stripe.end), drawing.x_range().high);
  if (!(begin <= end)) {
    return std::nullopt;
  }
  return Extent{drawing.x(begin), drawing.x(end)};
}

}  // namespace

TopLabels::TopLabels(const Chart& chart, const Drawing& drawing) {
  const Box frame = drawing.frame();
  std::vector<Label> wanted;
  const auto want = [&](double middle, const std::string& label) {
    const std::string text = shortened(label, frame.width());
    const double half = 0.5 * text_width(text);
    wanted.push_back({std::max(std::min(middle, frame.right - half), frame.left + half), text});
  };
  for (const Stripe& stripe : chart.stripes) {
    if (const auto extent = shown(stripe, drawing); extent && !stripe.label.empty()) {
      want(0.5 * (extent->from + extent->to), stripe.label);
    }
  }
  for (const Level& level : chart.levels) {
    if (level.upright && !level.label.empty() && within(level.value, drawing.x_range())) {
      want(drawing.x(level.value), level.label);
    }
  }
  std::ranges::sort(wanted, [](const Label& a, const Label& b) {
    return a.middle != b.middle ? a.middle < b.middle : a.text < b.text;
  });
  std::array<double, most_rows> taken{};
  taken.fill(-1e9);
  for (Label& label : wanted) {
    const double half = 0.5 * text_width(label.text);
    const auto row = std::ranges::find_if(taken, [&](double end) { return end <= label.middle - half; });
    if (row != taken.end()) {
      *row = label.middle + half + 6.0;
      label.row = static_cast<std::size_t>(row - taken.begin());
      rows_ = std::max(rows_, label.row + 1);
      labels_.push_back(label);
    }
  }
}

void TopLabels::draw(Drawing& drawing) const {
  for (const Label& label : labels_) {
    drawing.add("<text class=\"mark\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", label.middle,
                drawing.frame().top - 5.0 - top_label_row * static_cast<double>(label.row), printed(label.text));
  }
}

void draw_stripes(Drawing& drawing, const Chart& chart) {
  for (const Stripe& stripe : chart.stripes) {
    if (const auto extent = shown(stripe, drawing)) {
      drawing.add(
          "<rect class=\"stripe\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
          "height=\"{:.1f}\"><title>{}</title></rect>",
          extent->from, drawing.frame().top, std::max(extent->to - extent->from, 1.0), drawing.frame().height(),
          printed(stripe.label));
    }
  }
}

void draw_levels(Drawing& drawing, const Chart& chart) {
  const Box frame = drawing.frame();
  for (const Level& level : chart.levels) {
    if (!within(level.value, level.upright ? drawing.x_range() : drawing.y_range())) {
      continue;
    }
    drawing.add("<path class=\"level {}\" d=\"", class_of(level.role));
    if (level.upright) {
      drawing.add("M{:.1f} {:.1f}V{:.1f}", drawing.x(level.value), frame.top, frame.bottom);
    } else {
      drawing.add("M{:.1f} {:.1f}H{:.1f}", frame.left, drawing.y(level.value), frame.right);
    }
    drawing.add("\"><title>{}</title></path>", printed(level.label));
  }
}

void label_levels(Drawing& drawing, LabelPlaces& places, const Chart& chart) {
  const Box frame = drawing.frame();
  for (const Level& level : chart.levels) {
    if (!level.upright && within(level.value, drawing.y_range())) {
      for (double x = frame.left; x <= frame.right; x += 3.0) {
        places.avoid({x, drawing.y(level.value)});
      }
    }
  }
  for (const Level& level : chart.levels) {
    if (level.upright || level.label.empty() || !within(level.value, drawing.y_range())) {
      continue;
    }
    constexpr double letters = 15.0;
    const std::string text = shortened(level.label, frame.width() - 12.0);
    const double width = text_width(text);
    const double y = drawing.y(level.value);
    std::vector<Box> candidates;
    for (const double share : {1.0, 0.0, 0.5, 0.25, 0.75}) {
      const double left = frame.left + 5.0 + share * (frame.width() - 10.0 - width);
      for (const double top : {y - letters - 1.0, y + 1.0}) {
        candidates.push_back({left, top, left + width, top + letters});
      }
    }
    if (const auto place = places.take(candidates)) {
      drawing.add("<text class=\"mark {}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", class_of(level.role), place->left,
                  place->bottom - 3.5, printed(text));
    }
  }
}

}  // namespace fantail::plot
