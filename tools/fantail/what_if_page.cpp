// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <limits>

#include <fmt/format.h>

#include "fantail/what_if.hpp"
#include "plot/chart.hpp"
#include "plot/page.hpp"
#include "report/numbers.hpp"

namespace fantail::tool {
namespace {

using plot::Role;

// Where ticks could not be replayed the curve has a gap.
constexpr double longest_step_s = 0.05;

plot::Series curve(const WhatIf& result, std::string name, Role role, const std::vector<double>& values_rad) {
  plot::Series series{.name = std::move(name), .role = role};
  for (std::size_t i = 0; i < values_rad.size(); ++i) {
    if (i > 0 && result.time_s[i] - result.time_s[i - 1] > longest_step_s) {
      series.x.push_back(0.5 * (result.time_s[i] + result.time_s[i - 1]));
      series.y.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    series.x.push_back(result.time_s[i]);
    series.y.push_back(report::degrees(values_rad[i]));
  }
  return series;
}

std::string chart(std::string_view what, std::vector<plot::Series> series, double height) {
  return plot::figure(plot::svg({.label = fmt::format("{} over time", what),
                                 .x_label = "time / s",
                                 .y_label = fmt::format("{} / deg", what),
                                 .height = height,
                                 .series = std::move(series),
                                 .least_left = 48.0}),
                      "");
}

std::vector<plot::Figure> figures(const WhatIf& result) {
  const auto share = [](double value) { return fmt::format("{:.1f}", 100.0 * value); };
  const std::string first = result.first_difference_s ? report::fixed(*result.first_difference_s, 3) : "none";
  return {{"First difference", first, result.first_difference_s ? "s" : "", "after lift-off or control start"},
          {"Largest difference", fmt::format("{:.2f}", report::degrees(result.largest_difference_rad)), "deg",
           fmt::format("at {:.3f} s", result.largest_difference_s)},
          {"Other commands", std::to_string(result.differing), "ticks",
           fmt::format("of {} replayed", result.time_s.size())},
          {"Saturated, flown", share(result.flown_saturated), "%", "of the time under control"},
          {"Saturated, what if", share(result.what_if_saturated), "%", "of the time under control"}};
}

}  // namespace

std::string what_if_html(const WhatIf& result) {
  plot::Page page{.kind = "Fantail replay: what if", .title = fmt::format("{}", fmt::join(result.changes, ", "))};
  page.subtitle = result.log;
  page.tone = plot::Tone::unsure;
  page.verdict_heading = "Not a prediction";
  page.verdict = open_loop_sentence;
  std::vector<double> difference_rad(result.time_s.size());
  std::ranges::transform(result.what_if_rad, result.flown_rad, difference_rad.begin(), std::minus{});
  page.body_html = plot::section(
      "Roll command", plot::figure_row(figures(result)) +
                          chart("roll command",
                                {curve(result, "what if", Role::model, result.what_if_rad),
                                 curve(result, "flown", Role::measured, result.flown_rad)},
                                300.0) +
                          chart("what if minus flown", {curve(result, "", Role::model, difference_rad)}, 190.0));
  page.body_html += plot::section(
      "The roll that was flown",
      chart("roll angle", {curve(result, "", Role::measured, result.roll_angle_rad)}, 190.0) +
          plot::paragraph("As the changed plan's flight law would have known it from the same sensors. Every tick is "
                          "in what_if.csv beside this page."));
  if (result.unreachable > 0) {
    page.body_html += plot::paragraph(fmt::format(
        "{} ticks are left out: a gap in the log comes before them, and no checkpoint.", result.unreachable));
  }
  return plot::html(page);
}

}  // namespace fantail::tool
