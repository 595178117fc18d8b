// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "page/svg_plot.hpp"

namespace fantail::page {

/// A ring or a cross stands for one place among many dots: it is drawn in front of everything else.
enum class Mark : std::uint8_t { line, step, points, line_and_points, ring, cross };
[[nodiscard]] constexpr bool is_landmark(Mark mark) { return mark == Mark::ring || mark == Mark::cross; }
[[nodiscard]] constexpr bool has_line(Mark mark) { return mark != Mark::points && !is_landmark(mark); }

/// What a colour says, the same on every page. A target is what finer lines are held against: the truth, a command.
enum class Role : std::uint8_t { measured, model, second_model, target, reference, limit, neutral, waiting };

struct Series {
  std::string name{};
  Role role = Role::measured;
  Mark mark = Mark::line;
  std::vector<double> x{};  ///< increasing for lines
  std::vector<double> y{};  ///< as long as x; not a number: a gap
};

/// The area between two curves: a band of uncertainty.
struct Area {
  std::string name{};
  Role role = Role::model;
  std::vector<double> x{};
  std::vector<double> low{};
  std::vector<double> high{};
};

/// A shaded stretch of the x axis. The name of a neutral one stands above it, that of a coloured one in the legend.
struct ShadedRange {
  double begin = 0.0;
  double end = 0.0;
  std::string label{};
  Role role = Role::neutral;
};

/// A line across the plot.
struct Level {
  double value = 0.0;
  std::string label{};
  bool upright = false;  ///< at an x, not at a y
  Role role = Role::neutral;
};

constexpr double full_page = 880.0;  ///< widths, in a plot's own units; text is 12 of them high
constexpr double half_page = 428.0;

/// One plot as an SVG that takes its colours from chart.css (light and dark), with axes, units and a legend when it has
/// more than one name. Long series are thinned without losing a peak. What cannot be drawn (empty, not a number) is
/// said in the plot.
struct Chart {
  std::string label{};    ///< what it shows, for those who do not see it
  std::string x_label{};  ///< "time / s"
  std::string y_label{};
  double width = full_page;
  double height = 280.0;  ///< more when legend and labels need it
  std::vector<Series> series{};
  std::vector<Area> areas{};
  std::vector<ShadedRange> shaded_ranges{};
  std::vector<Level> levels{};
  std::optional<Range> x_range{};  ///< else all that is drawn
  std::optional<Range> y_range{};
  Scale x_scale = Scale::linear;         ///< logarithmic: of values above zero
  bool equal_x_ticks_at_points = false;  ///< ticks at the x of the first series: counts, set points
  bool sampled = false;     ///< evenly over x: where a sample comes five times later than is usual, lines have a gap
  double least_left = 0.0;  ///< room beside the y axis at least: charts below each other line up
};

[[nodiscard]] std::string svg(const Chart& chart);

/// The room beside its y axis: what the least_left of charts below it must be for their frames to line up.
[[nodiscard]] double left_of_frame(const Chart& chart);

/// The same plot, or a heat map's, as a file of its own: with its style inside.
[[nodiscard]] std::string standalone(std::string svg);

}  // namespace fantail::page
