// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "page/chart.hpp"
#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tunnel/steps_report.hpp"

namespace fantail::tunnel {
namespace {

using page::Chart;
using page::Mark;
using page::Role;
using text::degrees;
using text::fixed;
using text::in_degrees;

constexpr double low_chart = 200.0;

std::string responses(const StepResult& result) {
  const std::vector<double>& time_s = result.record.time_s;
  const identify::model::Simulation& model = result.identified.simulation;
  const Chart angle{
      .label = fmt::format("Roll angle after step {}, measured and modelled", result.number),
      .x_label = "time after the step / s",
      .y_label = "roll angle / deg",
      .width = page::half_page,
      .height = low_chart,
      .series = {{.name = "measured", .x = time_s, .y = in_degrees(result.record.roll_angle_rad)},
                 {.name = "model", .role = Role::model, .x = time_s, .y = in_degrees(model.roll_angle_rad)},
                 {.name = "reference",
                  .role = Role::reference,
                  .x = {time_s.front(), time_s.back()},
                  .y = {degrees(result.step.to_rad), degrees(result.step.to_rad)}}}};
  const Chart rate{
      .label = fmt::format("Roll rate after step {}, measured and modelled", result.number),
      .x_label = "time after the step / s",
      .y_label = "roll rate / deg/s",
      .width = page::half_page,
      .height = low_chart,
      .series = {{.name = "measured", .x = time_s, .y = in_degrees(result.record.roll_rate_rad_s)},
                 {.name = "model", .role = Role::model, .x = time_s, .y = in_degrees(model.roll_rate_rad_s)}}};
  const std::array<std::string, 2> pair{
      page::figure(angle, fmt::format("Step {} at {:g} s, from {} to {} deg.", result.number, result.step.begin_s,
                                      fixed(degrees(result.step.from_rad), 0), fixed(degrees(result.step.to_rad), 0))),
      page::figure(rate,
                   fmt::format("alpha {} m2, beta {} m, disturbance {} to {} deg.",
                               fixed(result.identified.model.alpha_m2, 2), fixed(result.identified.model.beta_m, 2),
                               fixed(degrees(result.identified.model.node_rad.front()), 2),
                               fixed(degrees(result.identified.model.node_rad.back()), 2)))};
  return page::side_by_side(pair);
}

std::string over_steps(const StepTable& table, const char* label, const char* y_label, const Spread& spread,
                       double (*value)(const identify::model::RollModel&)) {
  Chart chart{.label = label,
              .x_label = "step",
              .y_label = y_label,
              .width = page::half_page,
              .height = low_chart,
              .series = {{.name = "identified", .mark = Mark::points}},
              .levels = {{.value = spread.mean, .label = "mean"}},
              .equal_x_ticks_at_points = true};
  for (const StepResult& result : table.steps) {
    chart.series[0].x.push_back(static_cast<double>(result.number));
    chart.series[0].y.push_back(value(result.identified.model));
  }
  return page::figure(chart,
                      fmt::format("{}: {} \u00b1 {}.", label, fixed(spread.mean, 3), fixed(spread.deviation, 3)));
}

std::vector<page::Cell> row(const std::string& first, const std::string& at, double alpha_m2, double beta_m,
                            double begin_rad, double end_rad, double angle_rad, double rate_rad_s) {
  return {{first},
          {at},
          {fixed(alpha_m2, 3)},
          {fixed(beta_m, 3)},
          {fixed(degrees(begin_rad), 3)},
          {fixed(degrees(end_rad), 3)},
          {fixed(degrees(angle_rad), 3)},
          {fixed(degrees(rate_rad_s), 3)}};
}

std::vector<page::Cell> row(const std::string& first, const StepTable& table, double Spread::* value) {
  return row(first, "", table.alpha_m2.*value, table.beta_m.*value, table.disturbance_begin_rad.*value,
             table.disturbance_end_rad.*value, table.mean_abs_angle_error_rad.*value,
             table.mean_abs_rate_error_rad_s.*value);
}

std::string steps_table(const StepTable& table) {
  static const std::array<page::Column, 8> columns{{{"step"},
                                                    {"at / s", true},
                                                    {"\u03b1 / m\u00b2", true},
                                                    {"\u03b2 / m", true},
                                                    {"begin / deg", true},
                                                    {"end / deg", true},
                                                    {"angle error / deg", true},
                                                    {"rate error / deg/s", true}}};
  std::vector<std::vector<page::Cell>> rows;
  for (const StepResult& result : table.steps) {
    const identify::model::RollModel& model = result.identified.model;
    const identify::model::Simulation& simulation = result.identified.simulation;
    rows.push_back(row(std::to_string(result.number), fmt::format("{:g}", result.step.begin_s), model.alpha_m2,
                       model.beta_m, model.node_rad.front(), model.node_rad.back(), simulation.mean_abs_angle_error_rad,
                       simulation.mean_abs_rate_error_rad_s));
  }
  rows.push_back(row("mean", table, &Spread::mean));
  rows.push_back(row("standard deviation", table, &Spread::deviation));
  return page::table(columns, rows);
}

}  // namespace

std::string steps_html(const StepsHeading& heading, const StepTable& table) {
  const std::array<std::string, 2> parameters{
      over_steps(table, "Damping alpha", "alpha / m\u00b2", table.alpha_m2,
                 [](const identify::model::RollModel& model) { return model.alpha_m2; }),
      over_steps(table, "Torque constant beta", "beta / m", table.beta_m,
                 [](const identify::model::RollModel& model) { return model.beta_m; })};
  const std::array<std::string, 2> disturbances{
      over_steps(table, "Disturbance at the begin, deg", "disturbance / deg",
                 {degrees(table.disturbance_begin_rad.mean), degrees(table.disturbance_begin_rad.deviation)},
                 [](const identify::model::RollModel& model) { return degrees(model.node_rad.front()); }),
      over_steps(table, "Disturbance at the end, deg", "disturbance / deg",
                 {degrees(table.disturbance_end_rad.mean), degrees(table.disturbance_end_rad.deviation)},
                 [](const identify::model::RollModel& model) { return degrees(model.node_rad.back()); })};
  std::string body = page::section(
      "Every step identified",
      steps_table(table) +
          page::paragraph(
              "begin, end: the disturbance at both ends of the stretch, as an equivalent fin offset; errors: mean "
              "absolute differences of measured and modelled roll.") +
          page::side_by_side(parameters) + page::side_by_side(disturbances));
  std::string all;
  for (const StepResult& result : table.steps) {
    all += responses(result);
  }
  body += page::section("Step responses, measured and modelled", all);
  if (!table.remarks.empty()) {
    body += page::section("Remarks", page::list(table.remarks));
  }
  return page::html({.kind = "Fantail tunnel report: steps",
                     .title = heading.log,
                     .subtitle = steps_basis(heading),
                     .body_html = body});
}

}  // namespace fantail::tunnel
