// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "page/page.hpp"
#include "text/layout.hpp"
#include "text/number.hpp"
#include "tunnel/flow.hpp"
#include "tunnel/json.hpp"

namespace fantail::tunnel {
namespace {

using page::Chart;
using page::Mark;
using page::Role;
using text::fixed;

Json line(const Line& line) {
  return {{"slope_m_s_per_rpm", rounded(line.slope)},
          {"offset_m_s", rounded(line.offset)},
          {"r_squared", rounded(line.r_squared)}};
}

std::string speed_over_time(const TunnelLog& log, const Flow& flow) {
  Chart chart{.label = "Wind speed over time with the steady segments shaded",
              .x_label = "time / s",
              .y_label = "wind speed / m/s",
              .series = {{.name = "sensor", .x = log.time_s, .y = log.wind_speed_m_s}}};
  for (const FlowPoint& p : flow.points) {
    chart.shaded_ranges.push_back({p.segment.begin_s, p.segment.end_s, fixed(p.segment.fan_rpm.value_or(0.0), 0)});
  }
  return page::figure(chart, "Wind speed over time. Shaded: where it was steady, with the fan's set point in rpm.");
}

std::vector<double> each(const Flow& flow, double (*value)(const FlowPoint&)) {
  std::vector<double> values(flow.points.size());
  std::ranges::transform(flow.points, values.begin(), value);
  return values;
}

double mean_of(const FlowPoint& p) { return p.mean_m_s; }
double rpm_of(const FlowPoint& p) { return p.segment.fan_rpm.value_or(0.0); }

std::string speed_over_fan(const Flow& flow) {
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
  return page::figure(chart, caption);
}

std::string distance_from_line(const Flow& flow) {
  Chart chart{.label = "Distance of each mean from the line",
              .x_label = "fan / rpm",
              .y_label = "mean minus line / m/s",
              .width = page::half_page,
              .series = {{.name = "steady means", .mark = Mark::points, .x = each(flow, rpm_of), .y = {}}},
              .levels = {{.value = 0.0, .label = "line"}}};
  for (const FlowPoint& p : flow.points) {
    chart.series[0].y.push_back(p.mean_m_s - flow.line->offset - flow.line->slope * rpm_of(p));
  }
  return page::figure(chart, "Distance of each mean from the line.");
}

// Curves over speed go from slow to fast.
Flow by_speed(Flow flow) {
  std::ranges::sort(flow.points, {}, mean_of);
  return flow;
}

std::string turbulence(const Flow& flow, const char* label, const char* y_label, const char* caption,
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
  return page::figure(chart, caption);
}

std::string points_table(const Flow& flow) {
  static const std::array<page::Column, 8> columns{{{"fan / rpm", true},
                                                    {"steady / s", true},
                                                    {"n", true},
                                                    {"mean / m/s", true},
                                                    {"\u03c3 / m/s", true},
                                                    {"\u0393 / m/s", true},
                                                    {"\u03c3/mean / %", true},
                                                    {"rounding / %", true}}};
  std::vector<std::vector<page::Cell>> rows;
  rows.reserve(flow.points.size());
  for (const FlowPoint& p : flow.points) {
    rows.push_back({{fixed(rpm_of(p), 0)},
                    {fmt::format("{:g} to {:g}", p.segment.begin_s, p.segment.end_s)},
                    {std::to_string(p.segment.count)},
                    {fixed(p.mean_m_s, 3)},
                    {fixed(p.deviation_m_s, 3)},
                    {fixed(p.gamma_m_s, 5)},
                    {fixed(100.0 * p.relative_deviation, 3)},
                    {fixed(100.0 * p.rounding_share, 3)}});
  }
  return page::table(columns, rows);
}

}  // namespace

namespace {

std::string flow_sentence(const Flow& flow) {
  return fmt::format("{} steady set point{}{}.", flow.points.size(), flow.points.size() == 1 ? "" : "s",
                     flow.line ? fmt::format(", speed = {:.6f} m/s per rpm x fan {} {:.3f} m/s", flow.line->slope,
                                             flow.line->offset < 0.0 ? "-" : "+", std::abs(flow.line->offset))
                               : "");
}

}  // namespace

std::string flow_text(const TunnelLog& log, const Flow& flow, std::size_t columns) {
  fmt::memory_buffer out;
  const auto print = [&out](const std::string& text) { out.append(text.data(), text.data() + text.size()); };
  print(fmt::format("{}: {} steady set points\n\n", log.name, flow.points.size()));
  text::Table table{{{"fan"},
                     {"steady"},
                     {"mean"},
                     {"deviation"},
                     {"Gamma"},
                     {"sigma/mean", 3},
                     {"of rounding", 2},
                     {"readings", 1}}};
  table.row({"    fan  ", "     steady  ", "     mean   ", "  deviation", "   Gamma    ", "  sigma/mean",
             "   of rounding", "   readings"});
  for (const FlowPoint& p : flow.points) {
    table.row({fmt::format("{:5.0f} rpm", p.segment.fan_rpm.value_or(0.0)),
               fmt::format(" {:>5g}-{:<5g} s", p.segment.begin_s, p.segment.end_s),
               fmt::format(" {:7.3f} m/s", p.mean_m_s), fmt::format(" {:6.3f} m/s", p.deviation_m_s),
               fmt::format(" {:8.5f} m/s", p.gamma_m_s), fmt::format(" {:7.3f} %", 100.0 * p.relative_deviation),
               fmt::format(" {:10.3f} %", 100.0 * p.rounding_share), fmt::format(" {:9}", p.segment.count)});
  }
  print(table.text(columns));
  if (flow.line) {
    print(fmt::format("\nspeed = {:.6f} m/s per rpm x fan {} {:.3f} m/s, R2 = {:.6f}\n", flow.line->slope,
                      flow.line->offset < 0.0 ? "-" : "+", std::abs(flow.line->offset), flow.line->r_squared));
  }
  print(flow.remarks.empty() ? "" : "\n");
  for (const std::string& remark : flow.remarks) {
    print("  " + remark + "\n");
  }
  return fmt::to_string(out);
}

std::string flow_json(const TunnelLog& log, const Flow& flow, const result::Made& made) {
  Json points = Json::array();
  for (const FlowPoint& p : flow.points) {
    points.push_back({{"fan_rpm", rounded(p.segment.fan_rpm)},
                      {"begin_s", rounded(p.segment.begin_s)},
                      {"end_s", rounded(p.segment.end_s)},
                      {"readings", p.segment.count},
                      {"mean_m_s", rounded(p.mean_m_s)},
                      {"deviation_m_s", rounded(p.deviation_m_s)},
                      {"gamma_m_s", rounded(p.gamma_m_s)},
                      {"relative_deviation", rounded(p.relative_deviation)},
                      {"relative_deviation_of_rounding", rounded(p.rounding_share)}});
  }
  Json all = {{"log", log.name},
              {"set_points", points},
              {"line", flow.line ? line(*flow.line) : Json{}},
              {"rounding_m_s", rounded(flow.rounding_m_s)},
              {"rounding_deviation_m_s", rounded(rounding_deviation(flow.rounding_m_s))},
              {"remarks", flow.remarks}};
  result::put_answer(all, result::Answer::none, flow_sentence(flow), made);
  return all.pretty();
}

std::string flow_html(const TunnelLog& log, const Flow& unsorted) {
  const Flow flow = by_speed(unsorted);
  std::vector<std::string> speeds{speed_over_fan(flow)};
  if (flow.line) {
    speeds.push_back(distance_from_line(flow));
  }
  const std::array<std::string, 2> turbulences{
      turbulence(
          flow, "Turbulence intensity as published against wind speed", "Gamma / m/s",
          "Turbulence intensity as published: variance over mean.", [](const FlowPoint& p) { return p.gamma_m_s; },
          [](const FlowPoint& p) { return p.rounding_share * p.rounding_share * p.mean_m_s; }),
      turbulence(
          flow, "Standard deviation over mean against wind speed", "sigma/mean / %",
          "The usual turbulence intensity: standard deviation over mean.",
          [](const FlowPoint& p) { return 100.0 * p.relative_deviation; },
          [](const FlowPoint& p) { return 100.0 * p.rounding_share; })};
  std::string body = page::section("Steady segments",
                                   speed_over_time(log, flow) + points_table(flow) +
                                       page::paragraph("n: readings; \u03c3: their standard deviation; \u0393 = "
                                                       "\u03c3\u00b2/mean, the turbulence intensity as published; "
                                                       "rounding: \u03c3/mean due to the sensor's rounding alone."));
  body += page::section("Speed and fan", page::side_by_side(speeds));
  body += page::section("Turbulence", page::side_by_side(turbulences));
  if (!flow.remarks.empty()) {
    body += page::section("Remarks", page::list(flow.remarks));
  }
  std::string subtitle = fmt::format("{} steady fan set points", flow.points.size());
  if (flow.line) {
    subtitle += fmt::format("; {:.5f} m/s per rpm, R2 {:.6f}", flow.line->slope, flow.line->r_squared);
  }
  return page::html(
      {.kind = "Fantail tunnel report: flow", .title = log.name, .subtitle = subtitle, .body_html = body});
}

}  // namespace fantail::tunnel
