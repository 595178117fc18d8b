// SPDX-License-Identifier: MIT
#include "tunnel/steps_overlay.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

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

std::string sentence(const StepTable& table, const Outlier& one) {
  const auto number = [&](double value) {
    return text::fixed(one.column->printed(value), decimals(table, *one.column));
  };
  const std::string_view heading = one.column->heading;  // "angle error / deg"
  const std::size_t slash = heading.find(" / ");
  return fmt::format("Step {}: {} {}{}, where the median of all is {}.", one.step, heading.substr(0, slash),
                     number(one.value), slash == heading.npos ? "" : fmt::format(" {}", heading.substr(slash + 3)),
                     number(one.median));
}

}  // namespace

std::vector<Outlier> outliers(const StepTable& table) {
  constexpr std::size_t fewest_steps = 5;
  std::vector<Outlier> all;
  if (table.steps.size() < fewest_steps) {
    return all;
  }
  for (const StepColumn& column : step_columns()) {
    std::vector<double> values;
    for (const StepResult& result : table.steps) {
      values.push_back(figures_of(result).*column.figure);
    }
    const double middle = median(values);
    std::vector<double> distances;
    std::ranges::transform(values, std::back_inserter(distances),
                           [&](double value) { return std::abs(value - middle); });
    const double spread = median(distances) / 0.6745;
    const double negligible = column.is_angle ? text::radians(0.1) : 0.02 * std::abs(middle);
    for (std::size_t i = 0; i < values.size() && spread > 0.0; ++i) {
      if (distances[i] > std::max(3.5 * spread, negligible)) {
        all.push_back({table.steps[i].number, &column, values[i], middle});
      }
    }
  }
  std::ranges::stable_sort(all, {}, &Outlier::step);
  return all;
}

std::string overlay_html(const StepTable& table) {
  const std::vector<Outlier> odd = outliers(table);
  page::Chart chart{.label = "All steps over each other: roll angle from where it was asked for before the step",
                    .x_label = "time after the step / s",
                    .y_label = "roll angle, in the sense of the step / deg",
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
    sentences.emplace_back("No step lies apart from the others in any figure.");
  }
  const auto goes_up = [](const StepResult& result) { return result.step.to_rad > result.step.from_rad; };
  const auto up = std::ranges::count_if(table.steps, goes_up);
  const bool begins = table.steps.size() > 1 && table.steps.front().number == 1;
  const bool both = up > 0 && up < std::ssize(table.steps);
  return page::figure(chart,
                      fmt::format("The measured roll angle of each step, from the reference before it.{}{}",
                                  both ? " Steps up and steps down are two bundles where the law settles beside its "
                                         "reference: each is drawn in its own sense, so they lie apart by twice that."
                                       : "",
                                  begins ? " Step 1 begins where control began, each other where the one before it "
                                           "ended: it may lie beside them."
                                         : "")) +
         (sentences.empty() ? "" : page::list(sentences));
}

}  // namespace fantail::tunnel
