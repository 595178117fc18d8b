// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <functional>
#include <iterator>

#include <fmt/core.h>

#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tunnel/json.hpp"
#include "tunnel/steps.hpp"
#include "tunnel/steps_overlay.hpp"

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

std::string airframe_source(const StepsHeading& heading) {
  return heading.airframe_source.empty() ? heading.vehicle : heading.airframe_source;
}

const char* name(identify::model::Start start) {
  return start == identify::model::Start::fitted ? "fitted" : "as measured";
}

// Vehicle, air and method in a sentence.
std::string basis(const StepsHeading& heading) {
  const std::string speed = heading.speed_m_s ? fmt::format("{:.3f} m/s", *heading.speed_m_s) : "the speed of each row";
  return fmt::format(
      "{}: inertia {:g} kg m2, reference area {:g} m2; {} ({}), density {:g} kg/m3 ({}); the first {:g} s of each "
      "step, "
      "method {}, initial angle and rate {}.",
      airframe_source(heading), heading.airframe.inertia_kg_m2, heading.airframe.reference_area_m2, speed,
      heading.speed_source, heading.density_kg_m3, heading.density_source, heading.options.seconds,
      name(heading.options.method), name(heading.options.start));
}

void add_figures(Json& json, const StepFigures& figures) {
  for (const StepColumn& column : step_columns()) {
    json[std::string{column.name}] = rounded(column.printed(figures));
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
  for (const StepColumn& column : step_columns()) {
    if (column.has_error()) {
      one[std::string{column.error_name}] = rounded(column.printed(standard_errors_of(result)));
    }
  }
  return one;
}

Json json_of(const std::vector<StepSpread>& spreads) {
  Json all;
  for (const auto& [column, spread] : spreads) {
    const Json interval{std::vector<Json>{rounded(column->printed(spread.low)), rounded(column->printed(spread.high))}};
    all[std::string{column->name}] = Json{{"seen", rounded(column->printed(spread.seen))},
                                          {"measurement", rounded(column->printed(spread.measurement))},
                                          {"between", rounded(column->printed(spread.between))},
                                          {"interval", interval}};
  }
  return all;
}

using Print = std::function<std::string(const StepColumn& column)>;

Print printed(const StepTable& table, const StepFigures& figures) {
  return [&](const StepColumn& column) { return fixed(column.printed(figures), decimals(table, column)); };
}

// Of the figures that have one.
Print printed(const StepTable& table, double Between::* part) {
  return [&table, part](const StepColumn& column) {
    const auto found = std::ranges::find(table.spreads, column.name, [](const auto& one) { return one.column->name; });
    return found == table.spreads.end() ? std::string{}
                                        : fixed(column.printed(found->spread.*part), decimals(table, column));
  };
}

struct Line {
  std::string label;
  Print print;
};

// What stands below the steps.
std::vector<Line> summary(const StepTable& table) {
  std::vector<Line> lines{{"mean", printed(table, table.mean)}};
  if (table.standard_deviation) {
    lines.push_back({"standard deviation", printed(table, *table.standard_deviation)});
    lines.push_back({"  of measurement", printed(table, &Between::measurement)});
    lines.push_back({"  between the steps", printed(table, &Between::between)});
  }
  return lines;
}

std::string row_text(const std::string& first, const Print& print) {
  std::string text = fmt::format("{:<21}", first);
  for (const StepColumn& column : step_columns()) {
    const bool begins_group =
        column.figure == &StepFigures::disturbance_begin_rad || column.figure == &StepFigures::mean_abs_angle_error_rad;
    text += fmt::format("{}{:>8}", begins_group ? "   " : " ", print(column));
  }
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

std::vector<page::Cell> row(const std::string& first, const std::string& at, const Print& print) {
  std::vector<page::Cell> cells{{first}, {at}};
  for (const StepColumn& column : step_columns()) {
    cells.push_back({print(column)});
  }
  return cells;
}

std::string table_html(const StepTable& table) {
  std::vector<page::Column> columns{{"step"}, {"at / s", true}};
  for (const StepColumn& column : step_columns()) {
    columns.push_back({std::string{column.heading}, true});
  }
  std::vector<std::vector<page::Cell>> rows;
  for (const StepResult& result : table.steps) {
    const StepFigures figures = figures_of(result);
    rows.push_back(
        row(std::to_string(result.number), fmt::format("{:g}", result.step.begin_s), printed(table, figures)));
  }
  for (const Line& line : summary(table)) {
    rows.push_back(row(line.label, "", line.print));
  }
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

std::string responses(const StepTable& table, const StepResult& result) {
  const identify::model::Simulation& model = result.identified.simulation;
  const std::vector<double>& time_s = result.record.time_s;
  Chart angle = response(result, "angle", "deg", result.record.roll_angle_rad, model.roll_angle_rad);
  angle.series.push_back({.name = "reference",
                          .role = Role::reference,
                          .x = {time_s.front(), time_s.back()},
                          .y = {degrees(result.step.to_rad), degrees(result.step.to_rad)}});
  const Chart rate = response(result, "rate", "deg/s", result.record.roll_rate_rad_s, model.roll_rate_rad_s);
  const StepFigures figures = figures_of(result);
  const Print print = printed(table, figures);
  const std::array<std::string, 2> pair{
      page::figure(angle, fmt::format("Step {} at {:g} s, from {} to {} deg.", result.number, result.step.begin_s,
                                      fixed(degrees(result.step.from_rad), 0), fixed(degrees(result.step.to_rad), 0))),
      page::figure(rate, fmt::format("alpha {} m2, beta {} m, disturbance {} to {} deg.", print(step_columns()[0]),
                                     print(step_columns()[1]), fixed(degrees(figures.disturbance_begin_rad), 2),
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
  const auto number = [&](const StepFigures& figures) {
    return fixed(column.printed(figures), decimals(table, column));
  };
  const std::string figures = table.standard_deviation
                                  ? fmt::format("mean {} {}, standard deviation {} {}", number(table.mean), column.unit,
                                                number(*table.standard_deviation), column.unit)
                                  : fmt::format("{} {}", number(table.mean), column.unit);
  return page::figure(chart, fmt::format("{}: {}.", label, figures));
}

}  // namespace

std::string steps_text(const StepsHeading& heading, const StepTable& table) {
  std::string text = fmt::format("{}: {} {}\n{}\n\n", heading.log, table.steps.size(),
                                 table.steps.size() == 1 ? "step" : "steps", basis(heading));
  text += fmt::format("{:21} {:>8} {:>8}   {:>17}   {:>17}\n", "", "alpha", "beta", "disturbance", "mean abs error of");
  const auto head = [&text](auto... cells) {
    text += fmt::format("{:21} {:>8} {:>8}   {:>8} {:>8}   {:>8} {:>8}\n", cells...);
  };
  head("", "", "", "begin", "end", "angle", "rate");
  head("step", "m2", "m", "deg", "deg", "deg", "deg/s");
  for (const StepResult& result : table.steps) {
    const StepFigures figures = figures_of(result);
    text += row_text(fmt::format("{:2} at {:g} s", result.number, result.step.begin_s), printed(table, figures));
  }
  for (const Line& line : summary(table)) {
    text += row_text(line.label, line.print);
  }
  text += "\n";
  for (const std::string& sentence : spread_sentences(table)) {
    text += sentence + "\n";
  }
  for (const std::string& remark : table.remarks) {
    text += "  " + remark + "\n";
  }
  return text;
}

std::string steps_json(const StepsHeading& heading, const StepTable& table, const result::Made& made) {
  Json steps = Json::array();
  for (const StepResult& result : table.steps) {
    steps.push_back(json_of(result));
  }
  Json all = {{"log", heading.log},
              {"vehicle", airframe_source(heading)},
              {"inertia_kg_m2", rounded(heading.airframe.inertia_kg_m2)},
              {"reference_area_m2", heading.airframe.reference_area_m2},
              {"speed_m_s", rounded(heading.speed_m_s)},
              {"speed_source", heading.speed_source},
              {"density_kg_m3", rounded(heading.density_kg_m3)},
              {"density_source", heading.density_source},
              {"method", name(heading.options.method)},
              {"initial_state", name(heading.options.start)},
              {"seconds", rounded(heading.options.seconds)},
              {"steps", steps},
              {"mean", json_of(table.mean)},
              {"standard_deviation", table.standard_deviation ? json_of(*table.standard_deviation) : Json{}},
              {"between_steps", json_of(table.spreads)},
              {"remarks", table.remarks}};
  result::put_answer(all, result::Answer::none, steps_sentence(table), made);
  return all.pretty();
}

std::string steps_html(const StepsHeading& heading, const StepTable& table) {
  const std::array<std::string, 2> parameters{over_steps(table, 0, "Damping alpha", "alpha / m\u00b2"),
                                              over_steps(table, 1, "Torque constant beta", "beta / m")};
  const std::array<std::string, 2> disturbances{
      over_steps(table, 2, "Disturbance at the beginning", "disturbance / deg"),
      over_steps(table, 3, "Disturbance at the end", "disturbance / deg")};
  std::string body = page::section(
      "Every step identified",
      table_html(table) +
          page::paragraph("begin, end: the disturbance at the beginning and end of each step, as an equivalent fin "
                          "offset; errors: mean absolute differences of measured and modelled roll.") +
          page::list(spread_sentences(table)) + page::side_by_side(parameters) + page::side_by_side(disturbances));
  std::string all;
  for (const StepResult& result : table.steps) {
    all += responses(table, result);
  }
  body += page::section("All steps together", overlay_html(table));
  body += page::section("Each step, measured and modelled", page::on_demand("Show each step alone", all));
  body += table.remarks.empty() ? "" : page::section("Remarks", page::list(table.remarks));
  return page::html(
      {.kind = "Fantail tunnel report: steps", .title = heading.log, .subtitle = basis(heading), .body_html = body});
}

}  // namespace fantail::tunnel
