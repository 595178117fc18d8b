// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "page/chart.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tunnel/steps.hpp"

namespace fantail::tunnel {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

page::Series way(const StepResult& result, std::string name, page::Role role) {
  page::Series series{.name = std::move(name), .role = role, .x = result.record.time_s};
  const double sense = result.step.to_rad < result.step.from_rad ? -1.0 : 1.0;
  for (const double angle_rad : result.record.roll_angle_rad) {
    series.y.push_back(text::degrees(sense * (angle_rad - result.step.from_rad)));
  }
  return series;
}

using text::degrees;
using text::fixed;
using text::in_degrees;

constexpr double low_chart = 200.0;

constexpr std::string_view source_of_intervals =
    "Each interval comes from the noise in the step's own roll angle, its autocorrelation included. It excludes "
    "unsteady air.";

/// "19.388 m2"
std::string with_unit(const StepTable& table, std::size_t figure, double value) {
  const result::Column column = step_column(table, figure);
  return fmt::format("{} {}", result::shown(column, value), column.unit.symbol);
}

std::string sentence(const StepTable& table, const Outlier& one) {
  return fmt::format("Step {}: {} {}; the median of all steps is {}.", one.step, step_fields[one.figure].label,
                     with_unit(table, one.figure, one.value),
                     result::shown(step_column(table, one.figure), one.median));
}

double value(std::size_t figure, const StepFigures& figures) {
  return std::get<double>(step_fields[figure].get(figures));
}

/// Where an estimate lies with a probability of 95 %.
const result::Range& interval_of(const StepResult& result, std::size_t figure) {
  const auto& known = result.identified.uncertainty.value();
  switch (figure) {
    case 0: return known.alpha_profile_m2;
    case 1: return known.interval[1];
    case 2: return known.interval[2];  // the first node
    default: return known.interval.back();
  }
}

/// An error bar at each step, as wide in a chart of few steps as in one of many, and wider than its dot.
std::vector<page::Area> error_bars(const StepTable& table, std::size_t figure) {
  const double per_si = step_fields[figure].unit.per_si;
  const auto reach = 0.015 * static_cast<double>(table.steps.back().number - table.steps.front().number + 1);
  std::vector<page::Area> bars;
  for (const StepResult& result : table.steps) {
    const auto x = static_cast<double>(result.number);
    if (const auto& [low, high] = interval_of(result, figure); low && high) {
      bars.push_back({.name = "95 % interval",
                      .role = page::Role::measured,
                      .x = {x - reach, x + reach},
                      .low = {per_si * *low, per_si * *low},
                      .high = {per_si * *high, per_si * *high}});
    }
  }
  return bars;
}

/// Where the dots hide them all.
std::string hidden(const page::Chart& chart) {
  constexpr double dot = 0.055;  // of the height of the chart
  double low = chart.levels.front().value;
  double high = low;
  double longest = 0.0;
  for (const page::Area& bar : chart.areas) {
    low = std::min(low, bar.low.front());
    high = std::max(high, bar.high.front());
    longest = std::max(longest, bar.high.front() - bar.low.front());
  }
  return longest > 0.0 && longest < dot * (high - low) ? " The intervals are narrower than the dots." : "";
}

result::Picture over_steps(const StepTable& table, std::size_t figure, const char* label, const char* y_label) {
  const double per_si = step_fields[figure].unit.per_si;
  const double mean = value(figure, table.mean);
  page::Chart chart{.label = label,
                    .x_label = "step",
                    .y_label = y_label,
                    .width = page::half_page,
                    .height = low_chart,
                    .series = {{.name = "identified", .mark = page::Mark::points}},
                    .areas = error_bars(table, figure),
                    .levels = {{.value = per_si * mean, .label = "mean"}},
                    .x_range = page::Range{static_cast<double>(table.steps.front().number) - 0.5,
                                           static_cast<double>(table.steps.back().number) + 0.5},
                    .equal_x_ticks_at_points = true};
  for (const StepResult& result : table.steps) {
    chart.series[0].x.push_back(static_cast<double>(result.number));
    chart.series[0].y.push_back(per_si * value(figure, figures_of(result)));
  }
  const std::string source = figure == 0 ? " " + std::string{source_of_intervals} : "";
  return {chart,
          fmt::format("{}: mean {}, standard deviation {}.{}{}", label, with_unit(table, figure, mean),
                      with_unit(table, figure, value(figure, *table.standard_deviation)), source, hidden(chart))};
}

std::string intervals(const StepTable& table) {
  std::string all;
  for (std::size_t figure = 0; figure < step_estimates; ++figure) {
    const result::Column column = step_column(table, figure);
    const auto& [low, high] = interval_of(table.steps.front(), figure);
    all += fmt::format("{}{} {} to {} {}", all.empty() ? "" : ", ", step_fields[figure].label,
                       low ? result::shown(column, *low) : "unknown", high ? result::shown(column, *high) : "unknown",
                       column.unit.symbol);
  }
  return fmt::format("95 % intervals: {}.", all);
}

page::Chart response(const StepResult& result, const char* what, const char* unit, const std::vector<double>& measured,
                     const std::vector<double>& modelled) {
  const std::vector<double>& time_s = result.record.time_s;
  return {.label = fmt::format("Roll {} after step {}, measured and modelled", what, result.number),
          .x_label = "time after the step / s",
          .y_label = fmt::format("roll {} / {}", what, unit),
          .width = page::half_page,
          .height = low_chart,
          .series = {{.name = "measured", .x = time_s, .y = in_degrees(measured)},
                     {.name = "model", .role = page::Role::model, .x = time_s, .y = in_degrees(modelled)}}};
}

}  // namespace

std::vector<Outlier> outliers(const StepTable& table) {
  constexpr std::size_t fewest_steps = 5;
  std::vector<Outlier> all;
  if (table.steps.size() < fewest_steps) {
    return all;
  }
  for (std::size_t figure = 0; figure < step_fields.size(); ++figure) {
    std::vector<double> values;
    values.reserve(table.steps.size());
    for (const StepResult& result : table.steps) {
      values.push_back(value(figure, figures_of(result)));
    }
    const double middle = median(values);
    std::vector<double> distances;
    std::ranges::transform(values, std::back_inserter(distances),
                           [&](double value) { return std::abs(value - middle); });
    const double spread = median(distances) / 0.6745;
    const bool is_angle = step_fields[figure].unit.per_si != 1.0;
    const double negligible = is_angle ? text::radians(0.1) : 0.02 * std::abs(middle);
    for (std::size_t i = 0; i < values.size() && spread > 0.0; ++i) {
      if (distances[i] > std::max(3.5 * spread, negligible)) {
        all.push_back({table.steps[i].number, figure, values[i], middle});
      }
    }
  }
  std::ranges::stable_sort(all, {}, &Outlier::step);
  return all;
}

std::vector<result::Block> overlay(const StepTable& table) {
  if (table.steps.size() < 2) {
    return {};
  }
  const std::vector<Outlier> odd = outliers(table);
  page::Chart chart{.label = "All steps over each other: roll angle from the reference before the step",
                    .x_label = "time after the step / s",
                    .y_label = "roll angle, in the direction of the step / deg",
                    .height = 320.0};
  std::vector<page::Series> named;
  for (const StepResult& result : table.steps) {
    if (std::ranges::find(odd, result.number, &Outlier::step) == odd.end()) {
      chart.series.push_back(way(result, odd.empty() ? "every step" : "the others", page::Role::neutral));
    } else {
      named.push_back(way(result, fmt::format("step {}", result.number), page::Role::model));
    }
  }
  chart.series.insert(chart.series.end(), named.begin(), named.end());
  for (const StepResult& result : table.steps) {
    const double height_deg = text::degrees(std::abs(result.step.to_rad - result.step.from_rad));
    if (std::ranges::find(chart.levels, height_deg, &page::Level::value) == chart.levels.end()) {
      chart.levels.push_back({.value = height_deg, .label = fmt::format("step of {} deg", text::brief(height_deg, 1))});
    }
  }
  std::vector<std::string> sentences;
  std::ranges::transform(odd, std::back_inserter(sentences), [&](const Outlier& one) { return sentence(table, one); });
  if (odd.empty() && table.steps.size() >= 5) {
    sentences.emplace_back("No step is an outlier in any figure.");
  }
  const auto goes_up = [](const StepResult& result) { return result.step.to_rad > result.step.from_rad; };
  const auto up = std::ranges::count_if(table.steps, goes_up);
  const bool begins = table.steps.size() > 1 && table.steps.front().number == 1;
  const bool both = up > 0 && up < std::ssize(table.steps);
  const std::string caption =
      fmt::format("The measured roll angle of each step, from the reference before it.{}{}",
                  both ? " Each step is drawn in its own direction. If the law settles beside its reference, steps "
                         "up and steps down form two bundles, apart by twice that error."
                       : "",
                  begins ? " Step 1 begins where control began, and each other step where the one before it ended, "
                           "so the first may lie apart."
                         : "");
  return {result::Picture{chart, caption}, result::Sentences{.all = sentences}};
}

std::vector<result::Block> over_steps(const StepTable& table) {
  if (table.steps.size() < 2) {
    return {fmt::format("{} {}", intervals(table), source_of_intervals)};
  }
  return {over_steps(table, 0, "Damping alpha", "alpha / m\u00b2"),
          over_steps(table, 1, "Torque constant beta", "beta / m"),
          over_steps(table, 2, "Disturbance at the beginning", "disturbance / deg"),
          over_steps(table, 3, "Disturbance at the end", "disturbance / deg")};
}

std::vector<result::Block> responses(const StepTable& table) {
  std::vector<result::Block> all;
  for (const StepResult& result : table.steps) {
    const identify::model::Simulation& model = result.identified.simulation;
    const std::vector<double>& time_s = result.record.time_s;
    page::Chart angle = response(result, "angle", "deg", result.record.roll_angle_rad, model.roll_angle_rad);
    angle.series.push_back({.name = "reference",
                            .role = page::Role::reference,
                            .x = {time_s.front(), time_s.back()},
                            .y = {degrees(result.step.to_rad), degrees(result.step.to_rad)}});
    const StepFigures figures = figures_of(result);
    all.emplace_back(result::Picture{
        angle, fmt::format("Step {} at {:g} s, from {} to {} deg.", result.number, result.step.begin_s,
                           fixed(degrees(result.step.from_rad), 0), fixed(degrees(result.step.to_rad), 0))});
    all.emplace_back(result::Picture{
        response(result, "rate", "deg/s", result.record.roll_rate_rad_s, model.roll_rate_rad_s),
        fmt::format("alpha {}, beta {}, disturbance {} to {} deg.", with_unit(table, 0, figures.alpha_m2),
                    with_unit(table, 1, figures.beta_m), fixed(degrees(figures.disturbance_begin_rad), 2),
                    fixed(degrees(figures.disturbance_end_rad), 2))});
  }
  return all;
}

}  // namespace fantail::tunnel
