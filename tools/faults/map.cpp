// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>
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

/// One fault: its cells stand behind each other in a result.
struct Row {
  const FaultRow* fault;
  std::string label;
  double top;
  std::vector<const CellResult*> cells{};
};

std::vector<Row> rows_of(const Result& result) {
  std::vector<Row> rows;
  for (const CellResult& cell : result.cells) {
    const FaultRow* const fault = cell.cell.row;
    if (rows.empty() || rows.back().fault != fault) {
      const double gap = !rows.empty() && rows.back().fault->device != fault->device ? device_gap : 0.0;
      rows.push_back({.fault = fault,
                      .label = fmt::format("{} {}", fault->device, fault->fault),
                      .top = (rows.empty() ? head_height : rows.back().top + row_height) + gap});
    }
    rows.back().cells.push_back(&cell);
  }
  return rows;
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
  const std::vector<Row> rows = rows_of(result);
  const std::vector<Phase> columns = phases_of(result);
  if (rows.empty()) {
    return {};
  }
  double left = 0.0;
  for (const Row& row : rows) {
    left = std::max(left, page::text_width(row.label) + 12.0);
  }
  const double column = (width - left) / static_cast<double>(columns.size());
  page::SvgPlot plot;
  plot.begin("chart", "What each fault in each phase came to", width, rows.back().top + row_height + 4.0);
  draw_key(plot, width);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    plot.add("<text class=\"axis\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>",
             left + column * (static_cast<double>(i) + 0.5), head_height - 6.0,
             page::printed(page::shortened(name(columns[i]), column - 4.0)));
  }
  for (const Row& row : rows) {
    plot.add("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", left - 8.0, row.top + 11.0,
             page::printed(row.label));
    for (const CellResult* cell : row.cells) {
      if (cell->colour == Colour::not_applicable) {
        continue;
      }
      const auto at = std::ranges::find(columns, cell->cell.phase) - columns.begin();
      plot.add(
          "<g><title>{}</title><rect class=\"cell {}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
          "height=\"{:.1f}\"/></g>",
          page::printed(fmt::format("{}: {}{}{}", cell->cell.name(), word_of(cell->colour),
                                    cell->figure.empty() ? "" : ", ", cell->figure)),
          class_of(cell->colour), left + column * static_cast<double>(at) + 1.0, row.top + 1.0, column - 2.0,
          row_height - 2.0);
    }
  }
  return plot.end();
}

}  // namespace fantail::faults
