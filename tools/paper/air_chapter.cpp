// SPDX-License-Identifier: MIT
// Section 4.1.1: how even the tunnel's air is.
#include <algorithm>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "paper/paper_page.hpp"
#include "paper/runs.hpp"
#include "tunnel/flow.hpp"

namespace fantail::paper {

Chapter air_chapter(const Tell& tell) {
  const Run run = fly("tunnel_flow", {}, tell);
  const tunnel::TunnelLog log = wind_log(run);
  const tunnel::Flow flow = tunnel::examine_flow(log, tunnel::find_steady(log, {}));
  Chapter chapter{.title = "The air of the tunnel",
                  .introduction =
                      "Six fan speeds, a sensor that reads every two seconds to 0.1 m/s. The readings are not "
                      "published: a simulated fan with 0.3 % turbulence stands in for the tunnel, so what is "
                      "shown here is the analysis, not their air."};
  const auto largest = std::ranges::max_element(flow.points, {}, &tunnel::FlowPoint::gamma_m_s);
  const std::string simulated = "The readings are not published; ours is a simulated tunnel.";
  chapter.claims.push_back(unpublished("Section 4.1.1, figure 11a", "Correlation of fan speed and wind speed, R2",
                                       "0.9999", simulated,
                                       flow.line ? fmt::format("{:.4f}", flow.line->r_squared) : "no line"));
  chapter.claims.push_back(
      unpublished("Section 4.1.1, eq 26, figures 10 and 11b", "Largest turbulence", "below 0.04 %", simulated,
                  fmt::format("{:.5f} m/s at {:.1f} m/s; standard deviation over mean {:.2f} %", largest->gamma_m_s,
                              largest->mean_m_s, 100.0 * largest->relative_deviation)));
  std::vector<double> steady_s;
  steady_s.reserve(flow.points.size());
  for (const tunnel::FlowPoint& point : flow.points) {
    steady_s.push_back(point.segment.begin_s);
  }
  chapter.claims.push_back(unpublished("Eq 25", "When each fan speed is steady, s", "100, 230, 390, 550, 718, 858",
                                       "It is not printed when each was set; ours are assumed.",
                                       fmt::format("{:.0f}", fmt::join(steady_s, ", "))));
  chapter.claims.push_back(compare(Numbers{.place = "Section 4.1.2",
                                           .what = "Highest wind speed",
                                           .theirs = 30.0,
                                           .ours = flow.points.back().mean_m_s,
                                           .unit = "m/s",
                                           .decimals = 1,
                                           .tolerance = 0.15,
                                           .kind = Kind::read_back,
                                           .remark = "It is an input of the simulated fan."}));
  chapter.claims.push_back(slip(
      "Section 4.1.1", "Unit of the turbulence of Eq 26", "%", "m/s",
      "A variance over a mean is a speed, as the notation says. In percent it would be the standard deviation over "
      "the mean: 0.0004 m/s at 22 m/s is a deviation of 0.09 m/s, 0.4 % of the mean."));
  page::Chart speed{.label = "Wind speed over time",
                    .x_label = "time / s",
                    .y_label = "wind speed / m/s",
                    .series = {curve(log.time_s, log.wind_speed_m_s, "reading", page::Role::measured)}};
  page::Series means{.name = "mean at a set point", .role = page::Role::measured, .mark = page::Mark::points};
  page::Series line{.name = "line through them", .role = page::Role::model};
  for (const tunnel::FlowPoint& point : flow.points) {
    speed.shaded_ranges.push_back({.begin = point.segment.begin_s,
                                   .end = point.segment.end_s,
                                   .label = fmt::format("{:.0f} rpm", point.segment.fan_rpm.value_or(0.0))});
    means.x.push_back(point.segment.fan_rpm.value_or(0.0));
    means.y.push_back(point.mean_m_s);
    if (flow.line) {
      line.x.push_back(means.x.back());
      line.y.push_back(flow.line->offset + flow.line->slope * means.x.back());
    }
  }
  chapter.figures_html.push_back(half_width_figure(speed, "As figure 10; shaded: the times found to be steady."));
  chapter.figures_html.push_back(half_width_figure({.label = "Fan speed against wind speed",
                                                    .x_label = "fan speed / rpm",
                                                    .y_label = "wind speed / m/s",
                                                    .series = {line, means}},
                                                   "As figure 11a."));
  return chapter;
}

}  // namespace fantail::paper
