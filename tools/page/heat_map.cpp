// SPDX-License-Identifier: MIT
#include "page/heat_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "page/page.hpp"
#include "page/svg_plot.hpp"

namespace fantail::page {
namespace {

// Nine points of "viridis" (public domain), which was made for even steps to the eye; straight between them.
constexpr std::array<Colour, 9> points{{{0x44, 0x01, 0x54},
                                        {0x47, 0x2d, 0x7b},
                                        {0x3b, 0x52, 0x8b},
                                        {0x2c, 0x72, 0x8e},
                                        {0x21, 0x90, 0x8c},
                                        {0x27, 0xad, 0x81},
                                        {0x5d, 0xc8, 0x63},
                                        {0xaa, 0xdc, 0x32},
                                        {0xfd, 0xe7, 0x25}}};

std::uint8_t between(std::uint8_t a, std::uint8_t b, double part) {
  return static_cast<std::uint8_t>(std::lround(a + part * (static_cast<double>(b) - a)));
}

constexpr double most_ratio = 1000.0;  // of a logarithmic key: below that all is alike

struct ColourScale {
  Range range;
  bool logarithmic;
  bool cut = false;  ///< there are values below the range

  [[nodiscard]] double part(double value) const {
    if (logarithmic) {
      return std::log(std::max(value, range.low) / range.low) / std::log(range.high / range.low);
    }
    return (value - range.low) / (range.high - range.low);
  }
};

// Empty: nothing to draw.
std::optional<ColourScale> colour_scale(const HeatMap& map) {
  std::optional<Range> all;
  std::optional<Range> above_zero;
  for (const double value : map.value) {
    include(all, value);
    if (value > 0.0) {
      include(above_zero, value);
    }
  }
  if (!all || map.x.empty() || map.y.empty() || map.value.size() < map.x.size() * map.y.size()) {
    return std::nullopt;
  }
  if (!map.logarithmic || !above_zero) {
    return ColourScale{drawable(*all), false};
  }
  const double low = std::max(above_zero->low, above_zero->high / most_ratio);
  Range range{low, above_zero->high};
  if (range.high / range.low < 1.0 + 1e-9) {
    range = {0.9 * low, 1.1 * low};
  }
  return ColourScale{range, true, all->low < low};
}

// Cells reach half way to their neighbours.
Range edges(const std::vector<double>& centres) {
  if (centres.empty()) {
    return {0.0, 1.0};
  }
  const double half =
      centres.size() < 2 ? 0.5 : 0.5 * (centres.back() - centres.front()) / static_cast<double>(centres.size() - 1);
  return drawable({centres.front() - half, centres.back() + half});
}

std::string hex(Colour colour) { return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue); }

double edge(double from, double to, std::size_t i, std::size_t count) {
  return from + (to - from) * static_cast<double>(i) / static_cast<double>(count);
}

// Neighbours of the same colour in a row are one rectangle.
void draw_cells(SvgPlot& plot, const HeatMap& map, const ColourScale& shade) {
  const Box frame = plot.frame();
  const std::size_t columns = map.x.size();
  plot.add("<g class=\"cells\">");
  for (std::size_t j = 0; j < map.y.size(); ++j) {
    const double bottom = edge(frame.bottom, frame.top, j, map.y.size());
    const double top = edge(frame.bottom, frame.top, j + 1, map.y.size());
    for (std::size_t i = 0; i < columns;) {
      const double value = map.value[j * columns + i];
      const std::size_t begin = i++;
      if (!std::isfinite(value)) {
        continue;
      }
      const Colour colour = colour_at(shade.part(value));
      while (i < columns && std::isfinite(map.value[j * columns + i]) &&
             colour_at(shade.part(map.value[j * columns + i])) == colour) {
        ++i;
      }
      // A little under and over the neighbours: rounded edges that only meet can leave a line between them.
      constexpr double under = 0.5;
      const double left = edge(frame.left, frame.right, begin, columns);
      const double right = edge(frame.left, frame.right, i, columns);
      const bool next = i < columns && std::isfinite(map.value[j * columns + i]);
      plot.add("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>", left, top,
               right - left + (next ? under : 0.0), bottom - top + (j > 0 ? under : 0.0), hex(colour));
    }
  }
  plot.add("</g>");
}

void draw_key(SvgPlot& plot, const std::vector<Tick>& ticks, const ColourScale& shade, double left, double right) {
  constexpr std::size_t steps = 96;
  constexpr double width = 14.0;
  const Box frame = plot.frame();
  plot.add("<g class=\"key\">");
  for (std::size_t i = 0; i < steps; ++i) {
    const double top = edge(frame.bottom, frame.top, i + 1, steps);
    plot.add("<rect x=\"{:.1f}\" y=\"{:.2f}\" width=\"{}\" height=\"{:.2f}\" fill=\"{}\"/>", left, top, width,
             edge(frame.bottom, frame.top, i, steps) - top,
             hex(colour_at(static_cast<double>(i) / static_cast<double>(steps - 1))));
  }
  plot.add("</g><rect class=\"edge\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.1f}\"/>", left, frame.top,
           width, frame.height());
  for (const Tick& tick : ticks) {
    const double y = frame.bottom - frame.height() * shade.part(tick.value);
    plot.add("<path class=\"tick\" d=\"M{:.1f} {:.1f}h4\"/><text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", left + width, y,
             left + width + 8.0, y + 4.2, tick.text);
  }
  if (shade.cut) {
    plot.add("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">and below</text>", right, frame.bottom + tick_row);
  }
}

constexpr double ring = 6.0;
constexpr double letters = 18.0;  // height of a label's box
constexpr double gap = 4.0;

// To the right, to the left, above, below; then all around, farther and farther away.
std::vector<Box> candidates(Pixel at, double width) {
  std::vector<Box> result;
  const auto centred = [&](double x, double y) {
    result.push_back({x - 0.5 * width, y - 0.5 * letters, x + 0.5 * width, y + 0.5 * letters});
  };
  const double beside = ring + gap + 0.5 * width;
  const double over = ring + gap + 0.5 * letters;
  centred(at.x + beside, at.y);
  centred(at.x - beside, at.y);
  centred(at.x, at.y - over);
  centred(at.x, at.y + over);
  for (int away = 1; away <= 9; ++away) {
    for (int i = 0; i < 12; ++i) {
      const double angle = std::numbers::pi / 6.0 * static_cast<double>(i);
      centred(at.x + (beside + 14.0 * away) * std::cos(angle), at.y - (over + 14.0 * away) * std::sin(angle));
    }
  }
  return result;
}

// Rings with labels that cover neither each other nor a ring; a label that had to move away is tied to its ring by a
// line. Spots outside the axes are left out.
void draw_spots(SvgPlot& plot, const std::vector<HeatMap::Spot>& spots) {
  LabelPlacer places{plot.frame()};
  struct VisibleSpot {
    Pixel at;
    std::string text;
  };
  std::vector<VisibleSpot> visible;
  for (const HeatMap::Spot& spot : spots) {
    if (spot.x >= plot.x_range().low && spot.x <= plot.x_range().high && spot.y >= plot.y_range().low &&
        spot.y <= plot.y_range().high) {
      const Pixel at{plot.x(spot.x), plot.y(spot.y)};
      visible.push_back({at, shortened(spot.label, 0.7 * plot.frame().width())});
      places.keep_free({at.x - ring, at.y - ring, at.x + ring, at.y + ring});
    }
  }
  for (const VisibleSpot& spot : visible) {
    const double width = text_width(spot.text) + 10.0;
    const auto box = spot.text.empty() ? std::nullopt : places.take(candidates(spot.at, width));
    if (box) {
      const double x = std::clamp(spot.at.x, box->left, box->right);
      const double y = std::clamp(spot.at.y, box->top, box->bottom);
      if (std::hypot(x - spot.at.x, y - spot.at.y) > ring + gap + 1.0) {
        for (const std::string_view part : {"halo", "leader"}) {
          plot.add("<path class=\"{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", part, spot.at.x, spot.at.y, x, y);
        }
      }
      plot.add(
          "<rect class=\"tag\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"3\"/>"
          "<text class=\"tag\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>",
          box->left, box->top, box->width(), box->height(), 0.5 * (box->left + box->right), box->bottom - 5.0,
          printed(spot.text));
    }
  }
  for (const VisibleSpot& spot : visible) {
    plot.add(
        "<circle class=\"halo\" cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2}\"/>"
        "<circle class=\"spot\" cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2}\"/>",
        spot.at.x, spot.at.y, ring - 1.0);
  }
}

}  // namespace

Colour colour_at(double part) {
  const double place = std::clamp(part, 0.0, 1.0) * static_cast<double>(points.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), points.size() - 2);
  const double rest = place - static_cast<double>(i);
  return {between(points[i].red, points[i + 1].red, rest), between(points[i].green, points[i + 1].green, rest),
          between(points[i].blue, points[i + 1].blue, rest)};
}

std::string svg(const HeatMap& map) {
  const std::optional<ColourScale> shade = colour_scale(map);
  const Range x = edges(map.x);
  const Range y = edges(map.y);
  const double below = tick_row + (map.x_label.empty() ? 0.0 : label_row) + 7.0;
  const bool two_rows = text_width(map.y_label) + text_width(map.value_label) + 40.0 > map.width;
  const double top = two_rows ? 42.0 : 25.0;
  const double height = std::max(map.height, top + 80.0 + below);

  const double wanted = std::max((height - below - top) / 36.0, 3.0);
  const std::vector<Tick> y_ticks = even_ticks(y, wanted);
  const std::vector<Tick> key_ticks = !shade               ? std::vector<Tick>{}
                                      : shade->logarithmic ? decade_ticks(shade->range, wanted)
                                                           : even_ticks(shade->range, wanted);
  const double left = tick_column(y_ticks);
  const double key = shade ? std::max(26.0 + tick_column(key_ticks), shade->cut ? 68.0 : 0.0) : 0.0;
  const Box frame{left, top, std::max(map.width - end_margin({}) - key, left + 40.0), height - below};

  SvgPlot plot;
  plot.place(frame, x, y);
  plot.begin("map", map.label, map.width, height);
  plot.outline("frame");
  plot.add("<text class=\"axis\" x=\"0\" y=\"{}\">{}</text>", two_rows ? 30 : 13,
           printed(shortened(map.y_label, map.width)));
  if (shade) {
    plot.add("<text class=\"axis\" x=\"{:.1f}\" y=\"13\" text-anchor=\"end\">{}</text>", map.width,
             printed(shortened(map.value_label, map.width)));
    draw_cells(plot, map, *shade);
    draw_key(plot, key_ticks, *shade, frame.right + 16.0, map.width);
  }
  plot.outline("edge");
  plot.x_axis(map.x.empty() ? std::vector<Tick>{} : even_ticks(x, frame.width() / 75.0), map.x_label);
  plot.y_axis(map.y.empty() ? std::vector<Tick>{} : y_ticks, false);
  if (shade) {
    draw_spots(plot, map.spots);
  } else {
    plot.remark("no data");
  }
  return plot.end();
}

}  // namespace fantail::page
