// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include "json/value.hpp"
#include "tunnel/steps.hpp"

namespace fantail::tunnel {
namespace {

using Json = json::Value;
using result::Cell;
namespace u = result::units;

constexpr int steps_decimals = 8;

constexpr auto step_row_fields = result::fields<StepResult>({
    {"step", "step", u::none, 0, &StepResult::number,
     "number of the step, counted from 1 over all changes of the reference"},
    {"begin", "at", u::s, 3, [](const StepResult& r) { return Cell{r.step.begin_s}; },
     "its first sample, by the log's clock"},
    {"from", "from", u::deg, 1, [](const StepResult& r) { return Cell{r.step.from_rad}; }, "the reference before it"},
    {"to", "to", u::deg, 1, [](const StepResult& r) { return Cell{r.step.to_rad}; }, "the reference after it"},
    {"samples", "samples", u::none, 0, [](const StepResult& r) { return Cell{std::uint64_t{r.identified.samples}}; },
     "samples used"},
    {"seconds", "seconds", u::none, 3, [](const StepResult& r) { return Cell{r.identified.seconds}; },
     "their length in seconds"},
});

const char* name(identify::result::Method method) {
  return method == identify::result::Method::grid ? "grid" : "continuous";
}

const char* name(identify::model::Start start) {
  return start == identify::model::Start::fitted ? "fitted" : "as measured";
}

std::string airframe_source(const StepsHeading& heading) {
  return heading.airframe_source.empty() ? heading.vehicle : heading.airframe_source;
}

/// Vehicle, air and method in a sentence.
std::string basis(const StepsHeading& heading) {
  const std::string speed = heading.speed_m_s ? fmt::format("{:.3f} m/s", *heading.speed_m_s) : "the speed of each row";
  return fmt::format(
      "{}: inertia {:g} kg m2, reference area {:g} m2; {} ({}), density {:g} kg/m3 ({}). The first {:g} s of each "
      "step, method {}, initial angle and rate {}.",
      airframe_source(heading), heading.airframe.inertia_kg_m2, heading.airframe.reference_area_m2, speed,
      heading.speed_source, heading.density_kg_m3, heading.density_source, heading.options.seconds,
      name(heading.options.method), name(heading.options.start));
}

std::string sentence(const StepTable& table, const StepSpread& one) {
  const result::Column column = step_column(table, one.figure);
  const auto& spread = one.spread;
  const auto number = [&](double value) { return result::shown(column, value); };
  if (spread.between == 0.0) {
    return fmt::format(
        "From step to step {} varies no more than measurement errors explain (95 %: at most {} {}). The estimates "
        "scatter by {}, their measurement errors by {}.",
        column.label, number(spread.high), column.unit.symbol, number(spread.seen), number(spread.measurement));
  }
  return fmt::format(
      "From step to step {} varies by {} {} (95 %: {} to {}) beyond the measured noise, which excludes turbulence. The "
      "estimates scatter by {}, their measurement errors by {}.",
      column.label, number(spread.between), column.unit.symbol, number(spread.low), number(spread.high),
      number(spread.seen), number(spread.measurement));
}

std::vector<std::string> spread_sentences(const StepTable& table) {
  std::vector<std::string> all;
  std::ranges::transform(table.spreads, std::back_inserter(all),
                         [&table](const StepSpread& one) { return sentence(table, one); });
  return all;
}

Json between_steps(const StepTable& table) {
  Json all;
  for (const auto& [figure, spread] : table.spreads) {
    const result::Unit& unit = step_fields[figure].unit;
    const auto value = [&unit](double si) { return result::json_of(unit, si, steps_decimals); };
    all[std::string{step_fields[figure].key} + std::string{unit.suffix}] =
        Json{{"seen", value(spread.seen)},
             {"measurement", value(spread.measurement)},
             {"between", value(spread.between)},
             {"interval", Json::array({value(spread.low), value(spread.high)})}};
  }
  return all;
}

/// Further columns of the same rows.
void append(result::Table& to, const result::Table& more) {
  to.columns.insert(to.columns.end(), more.columns.begin(), more.columns.end());
  for (std::size_t i = 0; i < to.rows.size(); ++i) {
    to.rows[i].insert(to.rows[i].end(), more.rows[i].begin(), more.rows[i].end());
  }
}

std::vector<StepFigures> each(const StepTable& table, StepFigures (*of)(const StepResult&)) {
  std::vector<StepFigures> all(table.steps.size());
  std::ranges::transform(table.steps, all.begin(), of);
  return all;
}

/// All that a step tells, with the standard errors of what is estimated.
result::Table whole_table(const StepTable& table) {
  result::Table all = result::table("steps", table.steps, step_row_fields);
  append(all, result::table({}, each(table, figures_of), step_fields));
  result::Table errors = result::only(result::table({}, each(table, standard_errors_of), step_fields),
                                      {"alpha", "beta", "disturbance_begin", "disturbance_end"});
  for (result::Column& column : errors.columns) {
    column.key += "_standard_error";
  }
  append(all, errors);
  return all;
}

/// steps.csv: with whose rows they are, where somebody said it.
result::Table sheet(const StepsHeading& heading, const result::Table& whole) {
  result::Table sheet =
      result::only(whole, {"step", "begin", "alpha", "beta", "disturbance_begin", "disturbance_end",
                           "mean_abs_angle_error", "mean_abs_rate_error", "alpha_standard_error", "beta_standard_error",
                           "disturbance_begin_standard_error", "disturbance_end_standard_error"});
  sheet.key = "steps";
  for (const char* const key : {"vehicle", "reference_area_m2", "inertia_kg_m2"}) {
    sheet.columns.push_back({.key = key});
  }
  const auto exact = [](double value) { return result::Digits{fmt::format("{}", value)}; };
  for (std::vector<Cell>& row : sheet.rows) {
    row.insert(row.end(),
               {heading.vehicle, exact(heading.airframe.reference_area_m2), exact(heading.airframe.inertia_kg_m2)});
  }
  return sheet;
}

/// The steps and what they have in common; its heads are short, so that it fits into 80 columns.
result::Table read_table(const StepTable& table) {
  std::vector<StepFigures> figures = each(table, figures_of);
  std::vector<std::string> names;
  names.reserve(table.steps.size() + 2);
  for (const StepResult& result : table.steps) {
    names.push_back(fmt::format("{} at {:g} s", result.number, result.step.begin_s));
  }
  if (table.standard_deviation) {
    figures.push_back(table.mean);
    names.emplace_back("mean");
    figures.push_back(*table.standard_deviation);
    names.emplace_back("deviation");
  }
  result::Table all = result::table({}, figures, step_fields);
  for (const auto& [label, part] :
       {std::pair{"measurement", &Between::measurement}, std::pair{"between", &Between::between}}) {
    if (table.standard_deviation) {
      std::vector<Cell>& row = all.rows.emplace_back(step_fields.size());
      for (const StepSpread& one : table.spreads) {
        row[one.figure] = one.spread.*part;
      }
      names.emplace_back(label);
    }
  }
  constexpr std::array heads{"alpha", "beta", "begin", "end", "angle", "rate"};
  for (std::size_t i = 0; i < heads.size(); ++i) {
    all.columns[i] = step_column(table, i);
    all.columns[i].label = heads[i];
    all.columns[i].absent = "";
  }
  all.columns.insert(all.columns.begin(), result::Column{.key = "step", .label = "step"});
  for (std::size_t i = 0; i < names.size(); ++i) {
    all.rows[i].insert(all.rows[i].begin(), names[i]);
  }
  return all;
}

std::vector<result::Block> identified(const StepTable& table) {
  std::vector<result::Block> all{
      read_table(table),
      "begin, end: the disturbance at the beginning and end of each step, as an equivalent fin offset; angle, rate: "
      "mean absolute differences of measured and modelled roll."};
  if (table.standard_deviation) {
    all.emplace_back(
        "deviation: standard deviation over the steps; measurement: the part due to measurement errors; between: "
        "differences beyond the measured noise, turbulence of the air included.");
  }
  all.emplace_back(result::Sentences{.all = spread_sentences(table)});
  for (result::Block& picture : over_steps(table)) {
    all.push_back(std::move(picture));
  }
  return all;
}

/// The means, a sentence.
std::string means(const StepTable& table) {
  const std::string whose = table.steps.size() == 1 ? fmt::format("Step {}", table.steps.front().number)
                                                    : fmt::format("Mean of {} steps", table.steps.size());
  return fmt::format("{}: damping alpha {} m2, torque beta {} m.", whose,
                     result::shown(step_column(table, 0), table.mean.alpha_m2),
                     result::shown(step_column(table, 1), table.mean.beta_m));
}

/// Of a single step, the picture that a reader looks for.
result::Section each_alone(const StepTable& table) {
  const bool is_one = table.steps.size() == 1;
  return {is_one ? "Measured and modelled" : "Each step, measured and modelled", responses(table),
          result::Readers::files, is_one ? "" : "Show each step alone"};
}

}  // namespace

std::vector<result::Listed> listed_step_fields() {
  return {result::listed("steps[]", step_row_fields), result::listed("steps[], mean, standard_deviation", step_fields)};
}

result::Document steps_answer(const StepsHeading& heading, const StepTable& table, const result::Made& made) {
  using enum result::Readers;
  const auto rounded = [](double value) { return json::rounded(value, steps_decimals); };
  const std::string sentence = means(table);
  const result::Table whole = whole_table(table);
  return {.kind = "tunnel report: steps",
          .title = heading.log,
          .subtitle = basis(heading),
          .verdict = {.answer = result::Answer::none,
                      .heading = sentence.substr(0, sentence.find(':')),
                      .sentence = sentence},
          .facts = {{"log", "", heading.log},
                    {"vehicle", "", airframe_source(heading)},
                    {"inertia_kg_m2", "", rounded(heading.airframe.inertia_kg_m2)},
                    {"reference_area_m2", "", heading.airframe.reference_area_m2},
                    {"speed_m_s", "", heading.speed_m_s ? Json{rounded(*heading.speed_m_s)} : Json{}},
                    {"speed_source", "", heading.speed_source},
                    {"density_kg_m3", "", rounded(heading.density_kg_m3)},
                    {"density_source", "", heading.density_source},
                    {"method", "", name(heading.options.method)},
                    {"initial_state", "", name(heading.options.start)},
                    {"seconds", "", rounded(heading.options.seconds)}},
          .sections = {{table.steps.size() == 1 ? "Identified" : "Every step identified", identified(table)},
                       {"All steps together", overlay(table)},
                       each_alone(table),
                       {"Remarks", {result::Sentences{"remarks", table.remarks}}},
                       {"For programs",
                        {whole, result::figures("mean", table.mean, step_fields),
                         table.standard_deviation ? result::Block{result::figures(
                                                        "standard_deviation", *table.standard_deviation, step_fields)}
                                                  : result::Data{"standard_deviation", {}},
                         result::Data{"between_steps", between_steps(table)}},
                        programs}},
          .spreadsheets = {sheet(heading, whole)},
          .made = made,
          .json_decimals = steps_decimals};
}

}  // namespace fantail::tunnel
