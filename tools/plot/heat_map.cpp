// SPDX-License-Identifier: MIT
#include "plot/heat_map.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "plot/colour_scale.hpp"
#include "plot/drawing.hpp"
#include "plot/heat_spots.hpp"
#include "plot/lettering.hpp"

namespace fantail::plot {
namespace {

constexpr double most_ratio = 1000.0;  // of a logarithmic key: below that all is alike

struct Shades {
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
std::optional<Shades> shades(const HeatMap& map) {
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
    return Shades{drawable(*all), false};
  }
  const double low = std::max(above_zero->low, above_zero->high / most_ratio);
  Range range{low, above_zero->high};
  if (range.high / range.low < 1.0 + 1e-9) {
    range = {0.9 * low, 1.1 * low};
  }
  return Shades{range, true, all->low < low};
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
void draw_cells(Drawing& drawing, const HeatMap& map, const Shades& shade) {
  const Box frame = drawing.frame();
  const std::size_t columns = map.x.size();
  drawing.add("<g class=\"cells\">");
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
      const double left = edge(frame.left, frame.right, begin, columns);
      drawing.add("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>", left, top,
                  edge(frame.left, frame.right, i, columns) - left, bottom - top, hex(colour));
    }
  }
  drawing.add("</g>");
}

void draw_key(Drawing& drawing, const std::vector<Tick>& ticks, const Shades& shade, double left) {
  constexpr std::size_t steps = 96;
  constexpr double width = 14.0;
  const Box frame = drawing.frame();
  drawing.add("<g class=\"key\">");
  for (std::size_t i = 0; i < steps; ++i) {
    const double top = edge(frame.bottom, frame.top, i + 1, steps);
    drawing.add("<rect x=\"{:.1f}\" y=\"{:.2f}\" width=\"{}\" height=\"{:.2f}\" fill=\"{}\"/>", left, top, width,
                edge(frame.bottom, frame.top, i, steps) - top,
                hex(colour_at(static_cast<double>(i) / static_cast<double>(steps - 1))));
  }
  drawing.add("</g><rect class=\"edge\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.1f}\"/>", left, frame.top,
              width, frame.height());
  for (const Tick& tick : ticks) {
    const double y = frame.bottom - frame.height() * shade.part(tick.value);
    drawing.add("<path class=\"tick\" d=\"M{:.1f} {:.1f}h4\"/><text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", left + width,
                y, left + width + 8.0, y + 4.2, tick.text);
  }
  if (shade.cut) {
    drawing.add("<text x=\"{:.1f}\" y=\"{:.1f}\">and less</text>", left, frame.bottom + tick_row);
  }
}

}  // namespace

std::string svg(const HeatMap& map) {
  const std::optional<Shades> shade = shades(map);
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

  Drawing drawing;
  drawing.place(frame, x, y);
  drawing.begin("map", map.label, map.width, height);
  drawing.add("<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>", frame.left, top,
              frame.width(), frame.height());
  drawing.add("<text class=\"axis\" x=\"0\" y=\"{}\">{}</text>", two_rows ? 30 : 13,
              printed(shortened(map.y_label, map.width)));
  if (shade) {
    drawing.add("<text class=\"axis\" x=\"{:.1f}\" y=\"13\" text-anchor=\"end\">{}</text>", map.width,
                printed(shortened(map.value_label, map.width)));
    draw_cells(drawing, map, *shade);
    draw_key(drawing, key_ticks, *shade, frame.right + 16.0);
  }
  drawing.add("<rect class=\"edge\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>", frame.left, top,
              frame.width(), frame.height());
  drawing.x_axis(map.x.empty() ? std::vector<Tick>{} : even_ticks(x, frame.width() / 75.0), map.x_label, false);
  drawing.y_axis(map.y.empty() ? std::vector<Tick>{} : y_ticks, false);
  if (shade) {
    draw_spots(drawing, map.spots);
  } else {
    drawing.remark("no data");
  }
  return drawing.end();
}

}  // namespace fantail::plot
