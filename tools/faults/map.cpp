// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <vector>

#include <fmt/core.h>

#include "faults/results.hpp"
#include "page/page.hpp"
#include "page/svg_plot.hpp"

namespace fantail::faults {
namespace {

constexpr double row_height = 15.0;
constexpr double device_gap = 8.0;
constexpr double head_height = 40.0;

const char* class_of(Colour colour) {
  switch (colour) {
    case Colour::green: return "good";
    case Colour::red: return "bad";
    case Colour::known_limit:
    case Colour::limit_without_need: return "unsure";
    case Colour::not_judged: return "neutral";
    case Colour::not_applicable: break;
  }
  return "";
}

/// The phases that were asked for, in their order.
std::vector<Phase> phases_of(const Result& result) {
  std::vector<Phase> all;
  for (std::size_t i = 0; i < phases; ++i) {
    const auto phase = static_cast<Phase>(i);
    if (std::ranges::any_of(result.cells, [phase](const CellResult& cell) { return cell.cell.phase == phase; })) {
      all.push_back(phase);
    }
  }
  return all;
}

void draw_key(page::SvgPlot& plot, double width) {
  constexpr std::array keys{std::pair{Colour::green, "safe"}, std::pair{Colour::known_limit, "a known limit"},
                            std::pair{Colour::red, "RED"}, std::pair{Colour::not_judged, "not judged"}};
  double x = width;
  for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
    x -= page::text_width(key->second) + 24.0;
    plot.add(
        "<rect class=\"cell {}\" x=\"{:.1f}\" y=\"3\" width=\"12\" height=\"11\"/><text x=\"{:.1f}\" "
        "y=\"13\">{}</text>",
        class_of(key->first), x, x + 17.0, key->second);
  }
}

}  // namespace

std::string map_svg(const Result& result, double width) {
  const std::vector<Phase> columns = phases_of(result);
  double left = 0.0;
  double height = head_height;
  const FaultRow* last = nullptr;
  for (const CellResult& cell : result.cells) {
    if (cell.cell.row != last) {
      height += row_height + (last != nullptr && last->device != cell.cell.row->device ? device_gap : 0.0);
      last = cell.cell.row;
      left = std::max(left, page::text_width(fmt::format("{} {}", last->device, last->fault)) + 12.0);
    }
  }
  const double column = (width - left) / static_cast<double>(std::max<std::size_t>(columns.size(), 1));
  page::SvgPlot plot;
  plot.begin("chart", "What each fault in each phase came to", width, height + 4.0);
  draw_key(plot, width);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    plot.add("<text class=\"axis\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>",
             left + column * (static_cast<double>(i) + 0.5), head_height - 6.0,
             page::printed(page::shortened(name(columns[i]), column - 4.0)));
  }
  double y = head_height - row_height;
  last = nullptr;
  for (const CellResult& cell : result.cells) {
    if (cell.cell.row != last) {
      y += row_height + (last != nullptr && last->device != cell.cell.row->device ? device_gap : 0.0);
      last = cell.cell.row;
      plot.add("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", left - 8.0, y + 11.0,
               page::printed(fmt::format("{} {}", last->device, last->fault)));
    }
    if (cell.colour == Colour::not_applicable) {
      continue;
    }
    const auto at = std::ranges::find(columns, cell.cell.phase) - columns.begin();
    plot.add(
        "<g><title>{}</title><rect class=\"cell {}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
        "height=\"{:.1f}\"/></g>",
        page::printed(fmt::format("{}: {}{}{}", cell.cell.name(), word_of(cell.colour), cell.figure.empty() ? "" : ", ",
                                  cell.figure)),
        class_of(cell.colour), left + column * static_cast<double>(at) + 1.0, y + 1.0, column - 2.0, row_height - 2.0);
  }
  return plot.end();
}

}  // namespace fantail::faults
