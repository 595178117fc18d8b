// SPDX-License-Identifier: MIT
#include <array>

#include <fmt/core.h>

#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tunnel/json.hpp"
#include "tunnel/steps.hpp"

namespace fantail::tunnel {
namespace {

using page::Chart;
using page::Mark;
using page::Role;
using text::degrees;
using text::fixed;
using text::in_degrees;

constexpr double low_chart = 200.0;

const char* name(identify::result::Method method) {
  return method == identify::result::Method::grid ? "grid" : "continuous";
}

std::string vehicle(const StepsHeading& heading) {
  return heading.vehicle.empty() ? "from the command line" : heading.vehicle;
}

// Vehicle, air and method in a sentence.
std::string basis(const StepsHeading& heading) {
  const std::string speed = heading.speed_m_s ? fmt::format("{:.3f} m/s", *heading.speed_m_s) : "the speed of each row";
  return fmt::format(
      "{}: inertia {:g} kg m2, reference area {:g} m2; {} ({}), density {:g} kg/m3; the first {:g} s of each step, "
      "method {}.",
      vehicle(heading), heading.airframe.inertia_kg_m2, heading.airframe.reference_area_m2, speed, heading.speed_source,
      heading.density_kg_m3, heading.options.seconds, name(heading.options.method));
}

void add_figures(Json& json, const StepFigures& figures) {
  for (const StepColumn& column : step_columns()) {
    json[column.name] = rounded(column.printed(figures));
  }
}

Json json_of(const StepFigures& figures) {
  Json all;
  add_figures(all, figures);
  return all;
}

Json json_of(const StepResult& result) {
  Json one = {{"step", result.number},
              {"begin_s", rounded(result.step.begin_s)},
              {"from_deg", angle(result.step.from_rad)},
              {"to_deg", angle(result.step.to_rad)}};
  add_figures(one, figures_of(result));
  one["samples"] = result.identified.samples;
  one["seconds"] = rounded(result.identified.seconds);
  if (const auto& known = result.identified.uncertainty; known && known->standard_deviation.size() >= 2) {
    one["alpha_standard_deviation_m2"] = rounded(known->standard_deviation[0]);
    one["beta_standard_deviation_m"] = rounded(known->standard_deviation[1]);
    one["alpha_identifiable"] = known->alpha_identifiable;
  }
  return one;
}

std::string row_text(const std::string& first, const StepFigures& figures) {
  std::string text = fmt::format("{:<21}", first);
  for (const StepColumn& column : step_columns()) {
    const bool begins_group =
        column.figure == &StepFigures::disturbance_begin_rad || column.figure == &StepFigures::mean_abs_angle_error_rad;
    text += fmt::format("{}{:8.3f}", begins_group ? "   " : " ", column.printed(figures));
  }
  return text + "\n";
}

std::vector<page::Cell> row(const std::string& first, const std::string& at, const StepFigures& figures) {
  std::vector<page::Cell> cells{{first}, {at}};
  for (const StepColumn& column : step_columns()) {
    cells.push_back({fixed(column.printed(figures), 3)});
  }
  return cells;
}

std::string table_html(const StepTable& table) {
  std::vector<page::Column> columns{{"step"}, {"at / s", true}};
  for (const StepColumn& column : step_columns()) {
    columns.push_back({column.heading, true});
  }
  std::vector<std::vector<page::Cell>> rows;
  rows.reserve(table.steps.size() + 2);
  for (const StepResult& result : table.steps) {
    rows.push_back(row(std::to_string(result.number), fmt::format("{:g}", result.step.begin_s), figures_of(result)));
  }
  rows.push_back(row("mean", "", table.mean));
  rows.push_back(row("standard deviation", "", table.standard_deviation));
  return page::table(columns, rows);
}

Chart response(const StepResult& result, const char* what, const char* unit, const std::vector<double>& measured,
               const std::vector<double>& modelled) {
  const std::vector<double>& time_s = result.record.time_s;
  return {.label = fmt::format("Roll {} after step {}, measured and modelled", what, result.number),
          .x_label = "time after the step / s",
          .y_label = fmt::format("roll {} / {}", what, unit),
          .width = page::half_page,
          .height = low_chart,
          .series = {{.name = "measured", .x = time_s, .y = in_degrees(measured)},
                     {.name = "model", .role = Role::model, .x = time_s, .y = in_degrees(modelled)}}};
}

std::string responses(const StepResult& result) {
  const identify::model::Simulation& model = result.identified.simulation;
  const std::vector<double>& time_s = result.record.time_s;
  Chart angle = response(result, "angle", "deg", result.record.roll_angle_rad, model.roll_angle_rad);
  angle.series.push_back({.name = "reference",
                          .role = Role::reference,
                          .x = {time_s.front(), time_s.back()},
                          .y = {degrees(result.step.to_rad), degrees(result.step.to_rad)}});
  const Chart rate = response(result, "rate", "deg/s", result.record.roll_rate_rad_s, model.roll_rate_rad_s);
  const StepFigures figures = figures_of(result);
  const std::array<std::string, 2> pair{
      page::figure(angle, fmt::format("Step {} at {:g} s, from {} to {} deg.", result.number, result.step.begin_s,
                                      fixed(degrees(result.step.from_rad), 0), fixed(degrees(result.step.to_rad), 0))),
      page::figure(rate, fmt::format("alpha {} m2, beta {} m, disturbance {} to {} deg.", fixed(figures.alpha_m2, 2),
                                     fixed(figures.beta_m, 2), fixed(degrees(figures.disturbance_begin_rad), 2),
                                     fixed(degrees(figures.disturbance_end_rad), 2)))};
  return page::side_by_side(pair);
}

std::string over_steps(const StepTable& table, std::size_t place, const char* label, const char* y_label) {
  const StepColumn& column = step_columns()[place];
  const double mean = column.printed(table.mean);
  Chart chart{.label = label,
              .x_label = "step",
              .y_label = y_label,
              .width = page::half_page,
              .height = low_chart,
              .series = {{.name = "identified", .mark = Mark::points}},
              .levels = {{.value = mean, .label = "mean"}},
              .equal_x_ticks_at_points = true};
  for (const StepResult& result : table.steps) {
    chart.series[0].x.push_back(static_cast<double>(result.number));
    chart.series[0].y.push_back(column.printed(figures_of(result)));
  }
  return page::figure(chart, fmt::format("{}: {} \u00b1 {}.", label, fixed(mean, 3),
                                         fixed(column.printed(table.standard_deviation), 3)));
}

}  // namespace

std::string steps_text(const StepsHeading& heading, const StepTable& table) {
  std::string text = fmt::format("{}: {} steps\n{}\n\n", heading.log, table.steps.size(), basis(heading));
  text += "                        alpha     beta     disturbance / deg     mean abs error of\n";
  text += "step                       m2        m      begin      end    angle/deg  rate/deg/s\n";
  for (const StepResult& result : table.steps) {
    text += row_text(fmt::format("{:2} at {:g} s", result.number, result.step.begin_s), figures_of(result));
  }
  text += row_text("mean", table.mean);
  text += row_text("standard deviation", table.standard_deviation);
  text += table.remarks.empty() ? "" : "\n";
  for (const std::string& remark : table.remarks) {
    text += "  " + remark + "\n";
  }
  return text;
}

std::string steps_json(const StepsHeading& heading, const StepTable& table) {
  Json steps = Json::array();
  for (const StepResult& result : table.steps) {
    steps.push_back(json_of(result));
  }
  const Json all = {{"log", heading.log},
                    {"vehicle", vehicle(heading)},
                    {"inertia_kg_m2", rounded(heading.airframe.inertia_kg_m2)},
                    {"reference_area_m2", heading.airframe.reference_area_m2},
                    {"speed_m_s", rounded(heading.speed_m_s)},
                    {"speed_source", heading.speed_source},
                    {"density_kg_m3", rounded(heading.density_kg_m3)},
                    {"method", name(heading.options.method)},
                    {"seconds", rounded(heading.options.seconds)},
                    {"steps", steps},
                    {"mean", json_of(table.mean)},
                    {"standard_deviation", json_of(table.standard_deviation)},
                    {"remarks", table.remarks}};
  return all.pretty();
}

std::string steps_html(const StepsHeading& heading, const StepTable& table) {
  const std::array<std::string, 2> parameters{over_steps(table, 0, "Damping alpha", "alpha / m\u00b2"),
                                              over_steps(table, 1, "Torque constant beta", "beta / m")};
  const std::array<std::string, 2> disturbances{
      over_steps(table, 2, "Disturbance at the beginning, deg", "disturbance / deg"),
      over_steps(table, 3, "Disturbance at the end, deg", "disturbance / deg")};
  std::string body = page::section(
      "Every step identified",
      table_html(table) +
          page::paragraph("begin, end: the disturbance at the beginning and end of each step, as an equivalent fin "
                          "offset; errors: mean absolute differences of measured and modelled roll.") +
          page::side_by_side(parameters) + page::side_by_side(disturbances));
  std::string all;
  for (const StepResult& result : table.steps) {
    all += responses(result);
  }
  body += page::section("Step responses, measured and modelled", all);
  if (!table.remarks.empty()) {
    body += page::section("Remarks", page::list(table.remarks));
  }
  return page::html(
      {.kind = "Fantail tunnel report: steps", .title = heading.log, .subtitle = basis(heading), .body_html = body});
}

}  // namespace fantail::tunnel
