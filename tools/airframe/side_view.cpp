// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "airframe/model/body.hpp"
#include "airframe/summary.hpp"
#include "page/page.hpp"
#include "page/svg_plot.hpp"
#include "text/number.hpp"

namespace fantail::airframe {
namespace {

constexpr double edge = 14.0;
constexpr double label_row = 18.0;

/// From metres to the picture.
struct Scale {
  double width;
  double per_m;
  double axis_y;

  [[nodiscard]] double x(double position_m) const { return edge + position_m * per_m; }
  [[nodiscard]] double y(double away_m) const { return axis_y - away_m * per_m; }
};

double widest_m(const sim::Geometry& shape) {
  double radius_m = 0.5 * shape.diameter_m;
  for (const sim::Geometry::Transition& transition : shape.transitions) {
    radius_m = std::max(radius_m, 0.5 * transition.aft_diameter_m);
  }
  double span_m = 0.0;
  for (const auto& set : {shape.fins, shape.canards}) {
    span_m = std::max(span_m, set ? set->span_m : 0.0);
  }
  for (const sim::Geometry::MoreFins& more : shape.more_fins) {
    span_m = std::max(span_m, more.set.span_m);
  }
  return radius_m + span_m;
}

double longest_m(const sim::Geometry& shape) {
  const auto end_m = [](const sim::Geometry::FinSet& set) { return set.position_m + set.sweep_m + set.tip_chord_m; };
  double end = std::max(shape.length_m, shape.fins ? end_m(*shape.fins) : 0.0);
  for (const sim::Geometry::MoreFins& more : shape.more_fins) {
    end = std::max(end, end_m(more.set));
  }
  return end;
}

std::string body(const sim::Geometry& shape, const Scale& scale) {
  constexpr int points = 240;
  std::string upper;
  std::string lower;
  for (int i = 0; i <= points; ++i) {
    const double x_m = shape.length_m * i / points;
    const double r_m = model::radius_m(shape, x_m);
    upper += fmt::format("{}{:.1f},{:.1f}", i == 0 ? "M" : "L", scale.x(x_m), scale.y(r_m));
    lower.insert(0, fmt::format("L{:.1f},{:.1f}", scale.x(x_m), scale.y(-r_m)));
  }
  return fmt::format(R"(<path class="measured area" d="{0}{1}Z"/><path class="measured line" d="{0}{1}Z"/>)", upper,
                     lower);
}

/// The two of a set that are seen flat, and the one that is seen from its edge.
std::string fins(const sim::Geometry& shape, const sim::Geometry::FinSet& set, const char* role, const Scale& scale) {
  const double r_m = model::radius_m(shape, set.position_m + 0.5 * set.root_chord_m);
  std::string svg;
  for (const double side : {1.0, -1.0}) {
    const double tip_m = set.position_m + set.sweep_m;
    const std::string path = fmt::format(
        "M{:.1f},{:.1f}L{:.1f},{:.1f}L{:.1f},{:.1f}L{:.1f},{:.1f}Z", scale.x(set.position_m), scale.y(side * r_m),
        scale.x(tip_m), scale.y(side * (r_m + set.span_m)), scale.x(tip_m + set.tip_chord_m),
        scale.y(side * (r_m + set.span_m)), scale.x(set.position_m + set.root_chord_m), scale.y(side * r_m));
    svg += fmt::format(R"(<path class="{0} area" d="{1}"/><path class="{0} line" d="{1}"/>)", role, path);
  }
  return svg + fmt::format(R"(<path class="{} line" d="M{:.1f},{:.1f}H{:.1f}"/>)", role, scale.x(set.position_m),
                           scale.axis_y, scale.x(set.position_m + set.root_chord_m));
}

/// A mark on the axis with a line up or down to its label.
std::string mark(const char* role, double position_m, double foot_y, const std::string& label, const Scale& scale) {
  const double x = scale.x(position_m);
  const bool at_end = x + 5.0 + page::text_width(label) > scale.width;
  return fmt::format(
      R"(<path class="{0} dots" d="M{1:.1f},{2:.1f}h0.01"/><path class="{0} level" d="M{1:.1f},{2:.1f}V{3:.1f}"/>)"
      R"(<text class="axis mark" x="{4:.1f}" y="{5:.1f}" text-anchor="{6}">{7}</text>)",
      role, x, scale.axis_y, foot_y, at_end ? x - 5.0 : x + 5.0, foot_y, at_end ? "end" : "start",
      page::escape_html(label));
}

}  // namespace

std::string side_view(const sim::Geometry& shape, const Summary& summary, double width) {
  const double per_m = (width - 2.0 * edge) / longest_m(shape);
  const double half = widest_m(shape) * per_m;
  const Scale scale{.width = width, .per_m = per_m, .axis_y = edge + label_row + half};
  const double height = 2.0 * (edge + half + label_row);
  std::string svg = fmt::format(
      R"(<svg class="chart" xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:.0f} {1:.0f}" style="--w:{0:.0f}" role="img" aria-label="The rocket from the side">)"
      R"(<rect class="paper" width="{0:.0f}" height="{1:.0f}"/>)",
      width, height);
  svg += body(shape, scale);
  if (shape.fins) {
    svg += fins(shape, *shape.fins, "measured", scale);
  }
  for (const sim::Geometry::MoreFins& more : shape.more_fins) {
    svg += fins(shape, more.set, "measured", scale);
  }
  if (shape.canards) {
    svg += fins(shape, *shape.canards, "model", scale);
  }
  const model::Estimate& pressure = summary.build_up.centre_of_pressure_m;
  svg += fmt::format(R"(<path class="limit line" d="M{:.1f},{:.1f}H{:.1f}"/>)", scale.x(pressure.low), scale.axis_y,
                     scale.x(pressure.high));
  // One above and one below: neither line goes through the label of the other.
  if (summary.centre_of_gravity_m) {
    svg += mark("reference", *summary.centre_of_gravity_m, edge,
                fmt::format("centre of gravity {} m", ::fantail::text::fixed(*summary.centre_of_gravity_m, 3)), scale);
  }
  svg += mark("limit", pressure.value, height - edge,
              fmt::format("centre of pressure {} m", ::fantail::text::fixed(pressure.value, 3)), scale);
  return svg + "</svg>";
}

}  // namespace fantail::airframe
