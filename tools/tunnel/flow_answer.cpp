// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "page/chart.hpp"
#include "text/number.hpp"
#include "tunnel/flow.hpp"

namespace fantail::tunnel {
namespace {

using page::Chart;
using page::Mark;
using page::Role;
using result::Cell;
using text::fixed;
namespace u = result::units;

constexpr result::Unit fan_unit{"_rpm", "rpm"};
constexpr result::Unit per_rpm{"_m_s_per_rpm", "m/s per rpm"};

constexpr auto flow_point_fields = result::fields<FlowPoint>({
    {"fan", "fan", fan_unit, 0,
     [](const FlowPoint& p) { return p.segment.fan_rpm ? Cell{*p.segment.fan_rpm} : Cell{}; }, "the fan's set point"},
    {"begin", "from", u::s, 1, [](const FlowPoint& p) { return Cell{p.segment.begin_s}; },
     "first reading of the steady air"},
    {"end", "to", u::s, 1, [](const FlowPoint& p) { return Cell{p.segment.end_s}; }, "its last"},
    {"readings", "readings", u::none, 0, [](const FlowPoint& p) { return Cell{std::uint64_t{p.segment.count}}; },
     "readings of the sensor between the two"},
    {"mean", "mean", u::m_s, 3, &FlowPoint::mean_m_s, "their mean"},
    {"deviation", "deviation", u::m_s, 3, &FlowPoint::deviation_m_s, "their standard deviation, sigma"},
    {"gamma", "Gamma", u::m_s, 5, &FlowPoint::gamma_m_s,
     "sigma squared over mean, the turbulence intensity as published"},
    {"relative_deviation", "sigma/mean", u::percent, 3, &FlowPoint::relative_deviation,
     "the usual turbulence intensity"},
    {"relative_deviation_of_rounding", "of rounding", u::percent, 3, &FlowPoint::rounding_share,
     "sigma/mean due to the sensor's rounding alone"},
});

constexpr auto line_fields = result::fields<Line>({
    {"slope", "slope", per_rpm, 6, &Line::slope, "slope of wind speed over fan speed, by least squares"},
    {"offset", "offset", u::m_s, 3, &Line::offset, "wind speed of the line at zero fan speed"},
    {"r_squared", "R2", u::none, 6, &Line::r_squared, "share of the variance that the line explains"},
});

constexpr auto rounding_fields = result::fields<Flow>({
    {"rounding", "rounding", u::m_s, 3, &Flow::rounding_m_s, "resolution of the sensor; 0: none was found"},
    {"rounding_deviation", "deviation of rounding", u::m_s, 3,
     [](const Flow& flow) { return Cell{rounding_deviation(flow.rounding_m_s)}; },
     "standard deviation due to rounding alone"},
});

result::Picture speed_over_time(const TunnelLog& log, const Flow& flow) {
  Chart chart{.label = "Wind speed over time with the steady segments shaded",
              .x_label = "time / s",
              .y_label = "wind speed / m/s",
              .series = {{.name = "sensor", .x = log.time_s, .y = log.wind_speed_m_s}}};
  for (const FlowPoint& p : flow.points) {
    chart.shaded_ranges.push_back({p.segment.begin_s, p.segment.end_s, fixed(p.segment.fan_rpm.value_or(0.0), 0)});
  }
  return {chart, "Wind speed over time. Shaded: where it was steady, with the fan's set point in rpm."};
}

std::vector<double> each(const Flow& flow, double (*value)(const FlowPoint&)) {
  std::vector<double> values(flow.points.size());
  std::ranges::transform(flow.points, values.begin(), value);
  return values;
}

double mean_of(const FlowPoint& p) { return p.mean_m_s; }
double rpm_of(const FlowPoint& p) { return p.segment.fan_rpm.value_or(0.0); }

result::Picture speed_over_fan(const Flow& flow) {
  Chart chart{
      .label = "Mean wind speed against the fan's set point",
      .x_label = "fan / rpm",
      .y_label = "mean wind speed / m/s",
      .width = page::half_page,
      .series = {{.name = "steady means", .mark = Mark::points, .x = each(flow, rpm_of), .y = each(flow, mean_of)}}};
  std::string caption = "Mean wind speed against the fan's set point.";
  if (flow.line) {
    const auto [slowest, fastest] = std::ranges::minmax(chart.series[0].x);
    const auto at = [&](double rpm) { return flow.line->offset + flow.line->slope * rpm; };
    chart.series.push_back(
        {.name = "line", .role = Role::model, .x = {slowest, fastest}, .y = {at(slowest), at(fastest)}});
    caption += fmt::format(" R2 = {:.6f}.", flow.line->r_squared);
  }
  return {chart, caption};
}

result::Picture distance_from_line(const Flow& flow) {
  Chart chart{.label = "Distance of each mean from the line",
              .x_label = "fan / rpm",
              .y_label = "mean minus line / m/s",
              .width = page::half_page,
              .series = {{.name = "steady means", .mark = Mark::points, .x = each(flow, rpm_of), .y = {}}},
              .levels = {{.value = 0.0, .label = "line"}}};
  for (const FlowPoint& p : flow.points) {
    chart.series[0].y.push_back(p.mean_m_s - flow.line->offset - flow.line->slope * rpm_of(p));
  }
  return {chart, "Distance of each mean from the line."};
}

// Curves over speed go from slow to fast.
Flow by_speed(Flow flow) {
  std::ranges::sort(flow.points, {}, mean_of);
  return flow;
}

result::Picture turbulence(const Flow& flow, const char* label, const char* y_label, const char* caption,
                           double (*value)(const FlowPoint&), double (*of_rounding)(const FlowPoint&)) {
  Chart chart{
      .label = label,
      .x_label = "mean wind speed / m/s",
      .y_label = y_label,
      .width = page::half_page,
      .series = {
          {.name = "measured", .mark = Mark::line_and_points, .x = each(flow, mean_of), .y = each(flow, value)}}};
  if (flow.rounding_m_s > 0.0) {
    chart.series.push_back(
        {.name = "rounding alone", .role = Role::neutral, .x = chart.series[0].x, .y = each(flow, of_rounding)});
  }
  const double highest = std::ranges::max(chart.series[0].y);
  chart.y_range = page::Range{0.0, highest > 0.0 ? 1.1 * highest : 1.0};
  if (flow.rounding_m_s > 0.0) {
    chart.y_range->high = std::max(chart.y_range->high, 1.1 * std::ranges::max(chart.series[1].y));
  }
  return {chart, caption};
}

std::vector<result::Block> speed_and_fan(const Flow& flow, const Flow& sorted) {
  std::vector<result::Block> all{speed_over_fan(sorted)};
  if (flow.line) {
    all.emplace_back(distance_from_line(sorted));
    all.emplace_back(result::figures("line", *flow.line, line_fields));
  } else {
    all.emplace_back(result::Data{"line", {}});
  }
  return all;
}

std::vector<result::Block> turbulences(const Flow& sorted) {
  return {turbulence(
              sorted, "Turbulence intensity as published against wind speed", "Gamma / m/s",
              "Turbulence intensity as published: variance over mean.", [](const FlowPoint& p) { return p.gamma_m_s; },
              [](const FlowPoint& p) { return p.rounding_share * p.rounding_share * p.mean_m_s; }),
          turbulence(
              sorted, "Standard deviation over mean against wind speed", "sigma/mean / %",
              "The usual turbulence intensity: standard deviation over mean.",
              [](const FlowPoint& p) { return 100.0 * p.relative_deviation; },
              [](const FlowPoint& p) { return 100.0 * p.rounding_share; })};
}

result::Verdict verdict(const Flow& flow) {
  const std::string heading = text::counted(flow.points.size(), "steady set point");
  return {.answer = result::Answer::none,
          .heading = heading,
          .sentence =
              heading + (flow.line ? fmt::format(": speed = {:.6f} m/s per rpm x fan {} {:.3f} m/s.", flow.line->slope,
                                                 flow.line->offset < 0.0 ? "-" : "+", std::abs(flow.line->offset))
                                   : ": a line of wind speed over fan speed needs two different ones.")};
}

}  // namespace

std::vector<result::Listed> listed_flow_fields() {
  return {result::listed("", rounding_fields), result::listed("line", line_fields),
          result::listed("set_points[]", flow_point_fields)};
}

result::Document flow_answer(const TunnelLog& log, const Flow& flow, const result::Made& made) {
  using enum result::Readers;
  const Flow sorted = by_speed(flow);
  return {.kind = "tunnel report: flow",
          .title = log.name,
          .subtitle = "how steady the wind of the tunnel is",
          .verdict = verdict(flow),
          .facts = {{"log", "", log.name}},
          .sections = {{"Steady segments",
                        {speed_over_time(log, flow), result::table("set_points", flow.points, flow_point_fields),
                         "deviation: the readings' standard deviation, sigma; Gamma = sigma squared over mean, the "
                         "turbulence intensity as published; of rounding: sigma/mean due to the sensor's rounding "
                         "alone."}},
                       {"Speed and fan", speed_and_fan(flow, sorted)},
                       {"Turbulence", turbulences(sorted), files},
                       {"Remarks", {result::Sentences{"remarks", flow.remarks}}},
                       {"For programs", {result::figures("", flow, rounding_fields)}, programs}},
          .made = made,
          .json_decimals = 8};
}

}  // namespace fantail::tunnel
