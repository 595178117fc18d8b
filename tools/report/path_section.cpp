// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "flight/path.hpp"
#include "page/map.hpp"
#include "page/page.hpp"
#include "report/chart_drawer.hpp"
#include "report/phase_colors.hpp"
#include "report/sections.hpp"
#include "text/bearing.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

using flight::PathPoint;
using page::Chart;
using page::Role;
using result::Picture;
using Value = std::function<double(const PathPoint&)>;

constexpr double square = 400.0;
constexpr double flat = 180.0;

page::Series series(const std::vector<PathPoint>& path, std::string name, Role role, const Value& x, const Value& y) {
  page::Series result{.name = std::move(name), .role = role};
  std::ranges::transform(path, std::back_inserter(result.x), x);
  std::ranges::transform(path, std::back_inserter(result.y), y);
  return result;
}

// Towards where the rocket was farthest from the foot of its guide: the plane that shows most of the path.
double heading_rad(const std::vector<PathPoint>& path) {
  const PathPoint& farthest = *std::ranges::max_element(path, {}, flight::distance_m);
  return std::atan2(farthest.east_m, farthest.north_m);
}

/// From lift-off, where the rocket begins to move, to the landing; a fall without a parachute, outside the model, is
/// left out behind the apogee.
std::vector<PathPoint> shown(const flight::Flight& flight) {
  const std::optional<Landing> landing = landing_of(flight);
  const double end_s = !landing                   ? std::numeric_limits<double>::infinity()
                       : landing->under_parachute ? landing->at.time_s
                                                  : *flight.events.apogee_s;
  std::vector<PathPoint> path;
  for (const PathPoint& point : flight.path) {
    if (point.time_s >= 0.0 && point.time_s <= end_s) {
      path.push_back(point);
    }
  }
  return path;
}

/// The guide, the apogee and the landing, as far as the path goes.
void add_places(Chart& chart, const flight::Flight& flight, const Value& x, const Value& y) {
  const auto add = [&](std::string name, Role role, const PathPoint& point) {
    page::Series place = series({point}, std::move(name), role, x, y);
    place.mark = page::Mark::points;
    chart.series.push_back(std::move(place));
  };
  add("launch guide", Role::reference, PathPoint{});
  if (const auto top = apogee_of(flight)) {
    add("apogee", Role::model, *top);
  }
  if (const auto landing = landing_of(flight); landing && landing->under_parachute) {
    add("landing", Role::limit, landing->at);
  }
}

Chart from_the_side(const std::vector<PathPoint>& path, std::string distance, const Value& along) {
  return {.label = "Path from the side",
          .x_label = std::move(distance),
          .y_label = "height / m",
          .width = page::half_page,
          .height = square,
          .series = {series(path, "path", Role::measured, along, &PathPoint::height_m)}};
}

page::Series tilt(const std::vector<PathPoint>& path) {
  return series(path, "tilt of the axis", Role::measured, &PathPoint::time_s,
                [](const PathPoint& p) { return text::degrees(p.tilt_rad); });
}

/// Of a path of which nobody knows where it points and how the air met the rocket.
result::Section plane_section(const std::vector<PathPoint>& path) {
  const Chart tilted{.label = "Tilt",
                     .x_label = "time / s",
                     .y_label = "deg",
                     .width = page::half_page,
                     .height = square,
                     .series = {tilt(path)},
                     .sampled = true};
  return {"The path",
          {Picture{from_the_side(path, "distance across / m", &PathPoint::north_m),
                   "From the side, in the single vertical plane that is assumed for the trajectory; the direction of "
                   "that plane is unknown. The two axes have different scales."},
           Picture{tilted, "Tilt of the long axis from the vertical."}},
          result::Readers::files};
}

}  // namespace

result::Section path_section(const flight::Flight& flight) {
  const std::vector<PathPoint> path = shown(flight);
  if (path.empty()) {
    return {};
  }
  if (flight.path_frame == flight::PathFrame::plane) {
    return plane_section(path);
  }
  const double heading = heading_rad(path);
  const auto along = [sine = std::sin(heading), cosine = std::cos(heading)](const PathPoint& p) {
    return cosine * p.north_m + sine * p.east_m;
  };
  const long bearing_deg = text::bearing_deg(heading);
  const std::string direction = bearing_deg % 45 == 0 ? compass(*std::ranges::max_element(path, {}, flight::distance_m))
                                                      : fmt::format("{}\u00b0", bearing_deg);
  Chart side = from_the_side(path, fmt::format("distance towards {} / m", direction), along);
  Chart above{.label = "Path from above",
              .x_label = "east / m",
              .y_label = "north / m",
              .width = page::half_page,
              .height = square,
              .series = {series(path, "path", Role::measured, &PathPoint::east_m, &PathPoint::north_m)}};
  add_places(side, flight, along, &PathPoint::height_m);
  add_places(above, flight, &PathPoint::east_m, &PathPoint::north_m);
  page::give_one_scale(above);
  // As the charts over time above: a descent of minutes would squeeze the ascent.
  const auto [begin_s, end_s] = plot_window(flight);
  std::vector<PathPoint> ascent = path;
  std::erase_if(ascent, [end_s](const PathPoint& point) { return point.time_s > end_s; });
  Chart angles{
      .label = "Tilt and angle of attack",
      .x_label = "time / s",
      .y_label = "deg",
      .width = page::full_page,
      .height = flat,
      .series = {tilt(ascent), series(ascent, "angle of attack", Role::model, &PathPoint::time_s,
                                      [](const PathPoint& p) { return text::degrees(p.angle_of_attack_rad); })},
      .x_range = page::Range{begin_s, end_s},
      .sampled = true};
  shade_phases(angles, flight);
  return {
      "The path",
      {Picture{side, "From the side. The two axes have different scales."},
       Picture{above, "From above; the guide stands at 0, 0. Both axes have the same scale."},
       Picture{angles,
               "Tilt of the long axis from the vertical, and angle between the axis and the motion through the air."}},
      result::Readers::files};
}

}  // namespace fantail::report
