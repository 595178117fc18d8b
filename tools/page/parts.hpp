// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "page/chart.hpp"
#include "page/page.hpp"
#include "page/svg_plot.hpp"

namespace fantail::page {

// What a chart is drawn of, apart from its axes.

/// The name of its colour in chart.css.
[[nodiscard]] std::string_view class_of(Role role);
/// Is any of it a pair of numbers?
[[nodiscard]] bool anything_in(const Series& series);
[[nodiscard]] bool anything_in(const Area& area);

/// `style` is added to the class. Labels are told to keep away from the curve. Only what lies in the plot's x range
/// is looked at, and of each stretch without a gap not much more than one smallest and one largest value per two units
/// of the plot is drawn. `sampled`: as in Chart.
void draw(SvgPlot& plot, LabelPlacer& places, const Series& series, std::string_view style, bool sampled);
void draw(SvgPlot& plot, const Area& area, bool sampled);
/// The ring or the cross of a series at one place.
[[nodiscard]] std::string landmark(Pixel at, const Series& series);

void draw_shaded_ranges(SvgPlot& plot, const Chart& chart);
void draw_levels(SvgPlot& plot, const Chart& chart);
/// Of those that are not upright; after the curves, which they keep away from.
void label_levels(SvgPlot& plot, LabelPlacer& places, const Chart& chart);

constexpr double legend_row = 17.0;
constexpr double top_label_row = 15.0;

/// The names of a chart's curves, areas and coloured stripes, in rows above the frame beside the y axis' label.
class Legend {
 public:
  /// `styles` of the series, as they are drawn.
  Legend(const Chart& chart, const std::vector<std::string>& styles);

  /// 0 when there is neither a label nor more than one name.
  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  void draw(SvgPlot& plot) const;

 private:
  struct Entry {
    std::string name;
    std::string swatch{};  ///< SVG from the origin on
    std::string line{};    ///< likewise, over the swatch
    double width = 0.0;
  };

  const Chart& chart_;
  std::vector<std::vector<Entry>> rows_{};
};

/// The labels of neutral stripes and upright levels, in rows above the frame. One without room is left out; its text
/// still shows under a mouse.
class TopLabels {
 public:
  /// Only the plot's x is used.
  TopLabels(const Chart& chart, const SvgPlot& plot);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  void draw(SvgPlot& plot) const;

 private:
  struct Label {
    double left;
    std::string text;
    const Level* level = nullptr;  ///< of the chart; its line reaches up to the label
    std::size_t row = 0;           ///< upwards; the first level has the highest, so that its line crosses no label
  };

  std::vector<Label> labels_{};
  std::size_t rows_ = 0;
};

[[nodiscard]] std::string_view class_of(Tone tone);
/// <tag class="...">text</tag>, or nothing.
[[nodiscard]] std::string unless_empty(std::string_view tag, std::string_view kind, std::string_view text);

// The files of assets/ and of third_party/uplot, compiled in by embed.cmake.
extern const std::string_view chart_css;  ///< the palette and the drawings
extern const std::string_view chart_js;   ///< a cursor and zoom for each chart, and no folds on paper
extern const std::string_view page_css;   ///< what stands around them
extern const std::string_view live_js;
extern const std::string_view rocket_js;  ///< fantailRocket(), which scene_js needs
extern const std::string_view
    plot_frame_js;  ///< fantailPlotFrame(), fantailPlotOptions(), for pages that draw plots of their own
extern const std::string_view path_js;   ///< fantailPath(), likewise
extern const std::string_view scene_js;  ///< fantailScene(), which live_js needs where there is a scene
extern const std::string_view uplot_css;
extern const std::string_view uplot_js;
extern const std::string_view uplot_licence;

}  // namespace fantail::page
